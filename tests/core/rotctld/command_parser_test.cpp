// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/command_parser.h"

#include "core/rotctld/c_number.h"
#include "core/rotctld/foreign_protocol.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::rotctld {
namespace {

using Event = CommandParser::Event;

// The result of these bytes in pieces of this size: "p", "P(10,5)", "?" for an unknown command, "!" for a foreign
// protocol, "#" for a line that is too long.
std::string parsed(std::string_view bytes, std::size_t piece)
{
    CommandParser parser;
    std::string result;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
        std::string_view rest = bytes.substr(at, piece);
        for (Event event = parser.next(rest); event != Event::NeedMore; event = parser.next(rest)) {
            if (event != Event::Command) {
                result += event == Event::Odd ? '?' : event == Event::Foreign ? '!' : '#';
                if (event != Event::Odd) {
                    return result;
                }
                continue;
            }
            const Command& command = parser.command();
            result += static_cast<char>(command.spec->letter);
            for (std::size_t i = 0; i < command.argumentCount; ++i) {
                result += (i == 0 ? "(" : ",") + command.arguments[i];
            }
            result += command.argumentCount > 0 ? ")" : "";
        }
    }
    return result;
}

// The recorded exchanges test the rest of the protocol. These tests show what must not depend on packets.
TEST(CommandParser, ReadsTheSameInPiecesOfAnySize)
{
    const std::string bytes =
        "p\r\nP 10 5\n  \\set_pos\t1\n2\nM UP 50 pp\n# K\n|\\get_pos\nK\nV ?\nw raw bytes\nZ K S\np\nP10 5 p\n\\foo "
        "K\nK S\n";
    const std::string commands = "pP(10,5)P(1,2)M(UP,50)pppKV(?)w(raw bytes)?pP(10,5)p?KS";
    for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
        EXPECT_EQ(parsed(bytes, piece), commands) << piece;
    }
}

TEST(CommandParser, ThrowsAwayWhatFollowsAnUnknownCommand)
{
    EXPECT_EQ(parsed("\\foo S\nZ K \nGARBAGE P 10 5 \n", 100), "???");
    EXPECT_EQ(parsed("(KHTML, like Gecko)\n", 100), "?");
    EXPECT_EQ(parsed("STATS\nS;\nS\x80\n", 100), "???");
}

// Cut into packets so that an S is at the end of one. After garbage it must be a complete word.
TEST(CommandParser, AnSAfterNonsenseWaitsForTheEndOfItsWord)
{
    EXPECT_EQ(parsed("S", 1), "S");
    EXPECT_EQ(parsed("Z\nSTATS\n", 3), "??");
    EXPECT_EQ(parsed("Z\nS\n", 3), "?S");
}

TEST(CommandParser, TakesForgottenBackslashesOnlyAsWholeWords)
{
    EXPECT_EQ(parsed("set_pos 120 10\nget_pos\nstop\n", 100), "P(120,10)pS");
    EXPECT_EQ(parsed("set_position 1 2\n", 100), "se(t_position)1?");  // as Hamlib reads it
    EXPECT_EQ(parsed("p set_pos 1 2\n", 100), "pse(t_pos)1?");
}

TEST(CommandParser, EndsWithTheInput)
{
    CommandParser parser;
    std::string_view bytes = "K";
    EXPECT_EQ(parser.next(bytes), Event::NeedMore);
    EXPECT_EQ(parser.finish(), Event::Command);
    bytes = "P 10 5";
    EXPECT_EQ(parser.next(bytes), Event::NeedMore);
    EXPECT_EQ(parser.finish(), Event::Command);
    bytes = "P 10";
    EXPECT_EQ(parser.next(bytes), Event::NeedMore);
    EXPECT_EQ(parser.finish(), Event::NeedMore);
}

TEST(CommandParser, BoundsArgumentsAndLines)
{
    CommandParser parser;
    const std::string text = "P " + std::string(kMaxArgumentLength + 1, '1') + " 5\n";
    std::string_view bytes = text;
    EXPECT_EQ(parser.next(bytes), Event::Command);
    EXPECT_TRUE(parser.command().tooLong);
    EXPECT_EQ(parser.command().arguments[0].size(), kMaxArgumentLength);
    EXPECT_EQ(parsed(std::string(kMaxLineLength + 1, 'Z'), 1000), "?#");
    EXPECT_EQ(parsed(std::string(kMaxLineLength + 1, 'p'), 1000), std::string(kMaxLineLength, 'p') + "#");
    EXPECT_EQ(parsed("P " + std::string(kMaxLineLength, '1'), 1000), "#");
}

TEST(Numbers, EndWhereTheyNoLongerFit)
{
    EXPECT_EQ(leadingPosition("10.5deg"), 10.5F);
    EXPECT_EQ(leadingPosition("10\xc2\xb0"), 10.0F);
    EXPECT_EQ(leadingPosition("123,45"), 123.45F);
    EXPECT_EQ(leadingPosition("1,234.5"), 1.234F);
    EXPECT_EQ(leadingPosition("0x10"), 16.0F);
    EXPECT_EQ(leadingPosition("0x1p4"), 16.0F);
    EXPECT_EQ(leadingPosition("1e-05"), 1e-05F);
    EXPECT_EQ(leadingPosition("450.000001"), 450.0F);
    EXPECT_EQ(leadingPosition("-.5"), -0.5F);
    EXPECT_EQ(leadingInteger("50.5"), 50);
    EXPECT_EQ(leadingDouble("+10"), 10.0);
}

TEST(Numbers, RefuseWhatIsNoFiniteNumber)
{
    for (const char* text :
         {"", "-", "+", ".", "abc", "--5", "+-5", "nan", "NAN(1)", "inf", "-infinity", "1e400", "0x"}) {
        EXPECT_EQ(leadingPosition(text), std::nullopt) << text;
        EXPECT_EQ(leadingDouble(text), std::nullopt) << text;
    }
    EXPECT_EQ(leadingInteger("x"), std::nullopt);
    EXPECT_EQ(leadingInteger("99999999999"), std::nullopt);
}

TEST(ForeignProtocol, KnowsNoClientOfOurs)
{
    for (const char* line : {"p\n", "P 174,46 0,00\n", "S\n", "K\n", "M 8 50\n", "M 16 100\n", "_\n", "q\n",
                             "+\\dump_state\n", "C min_az 1\n", "set_pos 123.4 5.6\n", "|\\set_pos 113 10\n",
                             "E 10 30.5 1\n", "A 100\n", "W\n", "# GET /\n", "V SPEED 2\n"}) {
        EXPECT_EQ(foreignProtocolIn(line), std::nullopt) << line;
    }
}

}  // namespace
}  // namespace boresight::rotctld
