// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clients/protocol_log.h"

#include "core/clients/logged_rotator.h"
#include "core/easycomm_server/easycomm_controller.h"
#include "core/gs232_server/emulated_box.h"
#include "core/mqtt_commands/command_talk.h"
#include "core/pairs_server/pairs_talk.h"
#include "core/rotctld/session.h"
#include "core/udp_server/datagram_server.h"
#include "core/udp_server/pst_words.h"
#include "tests/fakes/dummy_rotator.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/wait_until.h"

#include <QUdpSocket>

#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <vector>

namespace boresight {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

constexpr std::size_t kAll = 10000;

class ProtocolLogTest : public testing::Test
{
protected:
    ProtocolLogTest() { log.setOn(true); }

    [[nodiscard]] rotctld::Client client(const char* protocol)
    {
        return {.id = ++m_newest, .address = "127.0.0.1:51234", .protocol = protocol};
    }
    void begin(const rotctld::StartConversation& start, const char* protocol) { m_talk = start(client(protocol)); }
    void speakRotctld() { begin(rotctld::talkRotctld(logged, clock, rotctld::DumpStateForm::OldAndNew), "rotctld"); }
    // Sends the bytes and returns the answers.
    std::string say(std::string_view bytes)
    {
        m_talk->receive(bytes);
        std::string reply;
        while (m_talk->step(reply)) {
        }
        return reply;
    }
    [[nodiscard]] std::vector<ProtocolLine> lines() const
    {
        const ProtocolLines all = log.newest(0, kAll);
        return all ? *all : std::vector<ProtocolLine>();
    }
    // "line | understood | answer" of each line since the last call, odd ones with "! " before.
    std::vector<std::string> fresh()
    {
        std::vector<std::string> texts;
        for (const ProtocolLine& one : lines()) {
            if (one.number > m_seen) {
                const QStringList parts{bytesText(one.line), understoodText(one), bytesText(one.answer)};
                texts.push_back((one.odd ? "! " : "") + parts.join(QStringLiteral(" | ")).toStdString());
            }
        }
        m_seen = log.lastNumber();
        return texts;
    }

    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
    ProtocolLog log{clock};
    LoggedRotator logged{rotator, log};

private:
    std::unique_ptr<rotctld::Conversation> m_talk;
    std::uint64_t m_newest = 0;
    std::uint64_t m_seen = 0;
};

// REQ-ROTCTLD-1430 (ProtocolLogTest.*): The protocol log has each line of each client of every protocol: the time, the
// client, the bytes, what Boresight understood, and the answer as sent. Odd commands are marked.
TEST_F(ProtocolLogTest, HasTheLinesOfRotctld)
{
    speakRotctld();
    EXPECT_EQ(say("P 113 10\n"), "RPRT 0\n");
    EXPECT_THAT(fresh(), ElementsAre("P 113 10 | go to 113.0° / 10.0° | RPRT 0"));
    say("p\r\nS\n_\n");
    EXPECT_THAT(fresh(), ElementsAre(StartsWith("p | asks the position | "), "S | stop | RPRT 0",
                                     "_ | command get_info | Dummy rotator"));
    say("K\nM 2 50\nR 1\nV SPEED 3\n\\get_pos\n");
    EXPECT_THAT(fresh(), ElementsAre("K | park | RPRT 0", "M 2 50 | move up | RPRT 0", "R 1 | reset | RPRT 0",
                                     "V SPEED 3 | set the jog speed to level 3 | RPRT 0",
                                     StartsWith("\\get_pos | asks the position")));
    rotator.became = QStringLiteral("az 40.0°");
    say("P 400 30\n");
    EXPECT_THAT(fresh(), ElementsAre("P 400 30 | go to 400.0° / 30.0° → az 40.0° | RPRT 0"));
    say("P 500 10\n");
    EXPECT_THAT(fresh(), ElementsAre("P 500 10 | go to 500.0° / 10.0°: refused. outside the limits | RPRT -1"));
}

TEST_F(ProtocolLogTest, NamesTimeAndClient)
{
    speakRotctld();
    clock.advance(3s);
    say("p\n");
    ASSERT_THAT(lines(), SizeIs(1));
    EXPECT_EQ(lines().front().utc, clock.utc());
    EXPECT_EQ(lines().front().client.toStdString(), "rotctld 127.0.0.1:51234");
    EXPECT_EQ(lines().front().clientId, 1U);
}

// The rest of a line that failed is part of the line, whenever it arrives. It is not part of the next line.
TEST_F(ProtocolLogTest, MarksTheOddLinesOfRotctld)
{
    speakRotctld();
    say("gabc de\nP 1 2\n");
    EXPECT_THAT(fresh(), ElementsAre("! gabc de | not understood | ", "P 1 2 | go to 1.0° / 2.0° | RPRT 0"));
    say("P abc 10 more\np\n");
    EXPECT_THAT(fresh(), ElementsAre(AllOf(StartsWith("! P abc 10 more | not understood: "), EndsWith(" | RPRT -1")),
                                     StartsWith("p | ")));
    say("\\nonsense\n");
    say("S\n");
    EXPECT_THAT(fresh(), ElementsAre("! \\\\nonsense | not understood | ", "S | stop | RPRT 0"));
    say("gab");
    say("cde\nS\n");
    EXPECT_THAT(fresh(), ElementsAre("! gab | not understood | ", "S | stop | RPRT 0"));
    say("GET / HTTP/1.1\r\n");
    EXPECT_THAT(fresh(), ElementsAre(AllOf(StartsWith("! G"), HasSubstr("not understood: is not a rotctld client"))));
}

TEST_F(ProtocolLogTest, HasALineThatArrivesInPieces)
{
    speakRotctld();
    say("P 11");
    say("3 ");
    EXPECT_THAT(fresh(), IsEmpty());
    say("10\n");
    EXPECT_THAT(fresh(), ElementsAre("P 113 10 | go to 113.0° / 10.0° | RPRT 0"));
}

// The answer to a command that asks for a pause comes at its end.
TEST_F(ProtocolLogTest, HasTheAnswerAfterAPause)
{
    speakRotctld();
    EXPECT_EQ(say("\\pause 2\n"), "");
    clock.advance(3s);
    EXPECT_EQ(say(""), "RPRT 0\n");
    EXPECT_THAT(fresh(), ElementsAre("\\pause 2 | command pause | ", " | command pause | RPRT 0"));
}

TEST_F(ProtocolLogTest, HasTheLinesOfGs232)
{
    begin(gs232::talkGs232(logged, clock, gs232::Dialect::B), "GS-232B");
    say("W113 010\r");
    EXPECT_THAT(fresh(), ElementsAre("W113 010 | go to 113.0° / 10.0° | \\r"));
    say("M120\rC2\r\nX3\rQ9\r");
    EXPECT_THAT(fresh(), ElementsAre(StartsWith("M120 | go to 120.0° / "), StartsWith("C2 | asks the position | AZ="),
                                     "X3 | set the jog speed to level 3 | \\r",
                                     AllOf(StartsWith("! Q9 | not understood: "), EndsWith(" | ?>"))));
}

TEST_F(ProtocolLogTest, HasTheLinesOfEasycomm)
{
    begin(easycomm::talkEasycomm(logged, clock, easycomm::Version::Two), "EasyComm II");
    say("AZ113.0 EL10.0 AZ EL\nSA SE\nVE\nUP145900000\n");
    EXPECT_THAT(fresh(), ElementsAre(StartsWith("AZ113.0 EL10.0 AZ EL | go to 113.0° / 10.0°, asks the position | AZ"),
                                     "SA SE | stop, stop | ", StartsWith("VE | asks for information | VEBoresight"),
                                     "UP145900000 | the line has no command for a rotator | "));
}

TEST_F(ProtocolLogTest, HasTheLinesOfPairs)
{
    begin(pairs::talkPairs(logged, clock, [] { return std::optional<Site>(); }), "pairs");
    say("113 10\n?\nhello\n");
    EXPECT_THAT(fresh(), ElementsAre("113 10 | go to 113.0° / 10.0° | OK", StartsWith("? | asks the position | "),
                                     AllOf(StartsWith("! hello | not understood: "), HasSubstr(" | error: "))));
    say("GET / HTTP/1.1\r\n");
    EXPECT_THAT(fresh(), ElementsAre(HasSubstr("! GET / HTTP/1.1 | not understood: is not a program for rotators")));
}

TEST_F(ProtocolLogTest, HasTheDatagrams)
{
    udp::DatagramServer server({.port = 0, .protocol = "PstRotator"}, udp::parsePst, logged, clock,
                               [](std::uint64_t) { return false; });
    ASSERT_TRUE(server.listen());
    QUdpSocket socket;
    const auto send = [&](const QByteArray& bytes) {
        const std::uint64_t before = log.lastNumber();
        socket.writeDatagram(bytes, QHostAddress(QStringLiteral("127.0.0.1")), server.port());
        return fakes::waitUntil([&] { return log.lastNumber() > before; });
    };
    ASSERT_TRUE(send("<PST><STOP>1</STOP></PST>"));
    ASSERT_TRUE(send("<PST>AZ?</PST>\n"));
    ASSERT_TRUE(send("hello"));
    EXPECT_THAT(fresh(), ElementsAre("<PST><STOP>1</STOP></PST> | stop | ",
                                     StartsWith("<PST>AZ?</PST> | asks the position | AZ:"),
                                     StartsWith("! hello | not understood: ")));
    EXPECT_THAT(lines().front().client.toStdString(), StartsWith("PstRotator 127.0.0.1:"));
}

TEST_F(ProtocolLogTest, HasTheMessagesOfTheBroker)
{
    mqtt::CommandTalk talk(
        {.id = 7, .address = "topic boresight/command", .protocol = "MQTT"}, logged, clock,
        [] { return std::optional<Site>(); }, [](const rotctld::Client&) { return Result<>(); });
    for (int i = 0; i < 100; ++i) {
        clock.advance(100ms);
        talk.tick();
    }
    const auto answer = talk.obey("113 10\n", mqtt::Retain::No);
    ASSERT_TRUE(answer);
    EXPECT_THAT(fresh(), ElementsAre("113 10 | go to 113.0° / 10.0° | " + answer->toStdString()));
    static_cast<void>(talk.stop("whatever", mqtt::Retain::No));
    static_cast<void>(talk.obey("hold", mqtt::Retain::Yes));
    EXPECT_THAT(fresh(),
                ElementsAre(StartsWith("whatever | command STOP | {"), StartsWith("hold | refused. The broker")));
    for (int i = 0; i < 30; ++i) {
        static_cast<void>(talk.obey("?", mqtt::Retain::No));
    }
    EXPECT_EQ(fresh().back(),
              "? | refused. More than 20 commands arrived in one second. Boresight ignores the rest. | ");
}

// REQ-ROTCTLD-1431: The protocol log keeps the newest 2000 lines, and of each line and answer the first 200 bytes with
// the number of all bytes.
TEST_F(ProtocolLogTest, IsBounded)
{
    speakRotctld();
    for (std::size_t i = 0; i < ProtocolLog::kCapacity + 10; ++i) {
        say("p\n");
    }
    EXPECT_THAT(lines(), SizeIs(ProtocolLog::kCapacity));
    EXPECT_EQ(lines().front().number, 11U);
    EXPECT_EQ(log.lastNumber(), ProtocolLog::kCapacity + 10);
    ASSERT_NE(log.oldest(0, 3), nullptr);
    EXPECT_THAT(*log.oldest(0, 3), SizeIs(3));
    EXPECT_EQ(log.oldest(0, 3)->front().number, 11U);
    EXPECT_EQ(log.oldest(20, 3)->front().number, 21U);
    EXPECT_EQ(log.newest(0, 3)->front().number, ProtocolLog::kCapacity + 8);
    EXPECT_EQ(log.oldest(log.lastNumber(), 3), nullptr);
    EXPECT_EQ(log.newest(log.lastNumber() + 5, 3), nullptr) << "a number of a station before";
    EXPECT_EQ(log.oldest(log.lastNumber() + 5, 3)->front().number, 11U) << "a number of a station before";
    fresh();
    say("g" + std::string(3000, 'x') + "\n");
    EXPECT_THAT(lines().back().line.begin, SizeIs(ProtocolBytes::kMost));
    EXPECT_THAT(fresh(), ElementsAre(AllOf(StartsWith("! gxxx"), HasSubstr("x… (3001 bytes) | not understood"))));
}

// REQ-ROTCTLD-1432: The protocol log is off at first. While it is off nothing is kept and no text of it is made.
TEST_F(ProtocolLogTest, CostsNothingWhileItIsOff)
{
    ProtocolLog unused(clock);
    EXPECT_FALSE(unused.isOn());
    log.setOn(false);
    speakRotctld();
    say("P 113 10\ngabc\np\n");
    begin(gs232::talkGs232(logged, clock, gs232::Dialect::B), "GS-232B");
    say("W113 010\rQ9\r");
    EXPECT_THAT(lines(), IsEmpty());
    EXPECT_EQ(log.lastNumber(), 0U);
}

// What a line asked before the log began, or half a line from then, is not taken for a part of the next line.
TEST_F(ProtocolLogTest, BeginsWithTheNextLine)
{
    log.setOn(false);
    speakRotctld();
    say("P 1 2\ngab");
    log.setOn(true);
    say("cde\nS\n");
    EXPECT_THAT(fresh(), ElementsAre(EndsWith("S | stop | RPRT 0")));
    log.setOn(false);
    say("P 1 2\n");
    EXPECT_THAT(fresh(), IsEmpty());
    EXPECT_THAT(lines(), SizeIs(1)) << "the lines stay";
}

// REQ-ROTCTLD-1433: The log shows each byte that does not print as \n, \r, \t or \x1b, and text of any language as it
// is. Two different lines never look the same.
TEST(ProtocolLine, EscapesWhatDoesNotPrint)
{
    const auto text = [](std::string_view bytes) { return bytesText(protocolBytes(bytes)).toStdString(); };
    EXPECT_EQ(text("P 1 2"), "P 1 2");
    EXPECT_EQ(text("P 1 2\r\n"), "P 1 2") << "the line end is left out";
    EXPECT_EQ(text("\r"), "\\r") << "there is nothing else";
    EXPECT_EQ(text(""), "");
    EXPECT_EQ(text("a\tb\nc\rd\x1b"
                   "e\x7f"),
              "a\\tb\\nc\\rd\\x1be\\x7f");
    EXPECT_EQ(text(std::string_view("\0x", 2)), "\\x00x");
    EXPECT_EQ(text("\\dump_state"), "\\dump_state");
    EXPECT_EQ(text("\\nonsense"), "\\\\nonsense") << "or it would read as a line end";
    EXPECT_EQ(text("\\\\"), "\\\\\\");
    EXPECT_EQ(text("OK: 90.0° 😀"), "OK: 90.0° 😀");
    EXPECT_EQ(text("\xff\xfe"
                   "a\xb0"),
              "\\xff\\xfea\\xb0")
        << "not UTF-8";
    EXPECT_EQ(text("\xc2\x85"), "\\xc2\\x85") << "UTF-8 that does not print";
}

TEST(ProtocolLine, CutsNoCharacterInTwo)
{
    const std::string bytes = std::string(ProtocolBytes::kMost - 1, 'x') + "°" + std::string(10, 'y');
    const ProtocolBytes kept = protocolBytes(bytes);
    EXPECT_EQ(kept.begin, std::string(ProtocolBytes::kMost - 1, 'x'));
    EXPECT_EQ(bytesText(kept).toStdString(), kept.begin + "… (211 bytes)");
}

TEST(ProtocolLine, IsALineOfAFile)
{
    const ProtocolLine line{.number = 5,
                            .utc = UtcTime(1795000000123ms),
                            .client = QStringLiteral("rotctld 127.0.0.1:51234"),
                            .line = protocolBytes("P\t113 10"),
                            .acts = {{.kind = ProtocolAct::Kind::Point, .azimuth = 113_deg, .elevation = 10_deg}},
                            .answer = protocolBytes("RPRT 0\n"),
                            .odd = true};
    EXPECT_EQ(fileText(line).toStdString(),
              "2026-11-18T11:06:40.123Z\trotctld 127.0.0.1:51234\todd\tP\\t113 10\tgo to 113.0° / 10.0°\tRPRT 0");
}

}  // namespace
}  // namespace boresight
