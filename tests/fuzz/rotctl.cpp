// SPDX-License-Identifier: GPL-3.0-or-later
// The replies of a rotctld: gives any bytes to the conversation with it and to the reading of its replies.
#include "core/base/control_characters.h"
#include "core/rotctl/reply_reader.h"
#include "core/rotctld_mount/rotctld_talk.h"
#include "core/serial/line_splitter.h"
#include "tests/fuzz/harness.h"

#include <algorithm>
#include <string>
#include <vector>

namespace boresight::fuzz {
namespace {

using namespace boresight::rotctl;
using Proof = RotatorTalk::Proof;

constexpr std::chrono::milliseconds kTick{20};
const AxisPosition kTarget{.azimuth = 123_deg, .elevation = 45_deg};

void checkReply(Question question, const Reply& reply)
{
    require(reply.code <= 0 && reply.code >= -99, "an error is one of Hamlib");
    const bool isValue = reply.code == 0;
    require(reply.position.has_value() == (isValue && question == Question::Position), "a position was asked for");
    require(reply.state.has_value() == (isValue && question == Question::State), "the limits were asked for");
    if (reply.position) {
        require(kPossibleAzimuth.contains(reply.position->azimuth) &&
                    kPossibleElevation.contains(reply.position->elevation),
                "a position is one of a rotator");
    }
    if (reply.state) {
        for (const Angle limit : {reply.state->azimuth.min, reply.state->azimuth.max}) {
            require(kPossibleAzimuth.contains(limit), "a limit is one of a rotator");
        }
    }
}

// Returns true if all lines are replies to this query.
bool checkLines(std::string_view bytes, Question question, Form form)
{
    bool understood = true;
    bool inside = false;
    ReplyReader reader(question, form);
    LineSplitter splitter;
    splitter.add(std::string(bytes) + "\n", [&](std::string_view line) {
        ReplyReader padded = reader;
        const auto progress = reader.take(line);
        require(padded.take("  " + std::string(line) + " ") == progress, "blanks around a line change nothing");
        inside = progress == ReplyReader::Progress::More;
        if (progress == ReplyReader::Progress::Whole) {
            checkReply(question, reader.reply());
        }
        understood = understood && progress != ReplyReader::Progress::Strange;
        reader = inside ? reader : ReplyReader(question, form);
    });
    return understood && !inside && splitter.overlongLines() == 0;
}

void checkSent(Proof before, const std::string& sent)
{
    static const std::vector<std::string> kQuestions{"", "+\\dump_state\n", "\\dump_state\n", "p\n"};
    static const std::vector<std::string> kCommands{"+\\get_pos\n", "+\\set_pos 123.00 45.00\n", "P 123.00 45.00\n",
                                                    "+\\stop\n", "S\n"};
    const bool isQuestion = std::ranges::find(kQuestions, sent) != kQuestions.end();
    if (before == Proof::Foreign) {
        require(sent.empty(), "a foreign server gets nothing more");
    } else if (before == Proof::Unknown) {
        require(isQuestion, "before an answer nothing but questions is sent");
    } else {
        // A rotator that cannot stop is sent to its present position.
        const bool isPlace = sent.starts_with("+\\set_pos ") || sent.starts_with("P ");
        require(isQuestion || isPlace || std::ranges::find(kCommands, sent) != kCommands.end(),
                "only our commands are sent");
        require(std::ranges::count(sent, '\n') <= 1, "one at a time");
    }
}

// In pieces of this size, one in each tick. The beginning may or may not be that of a rotctld.
void talked(std::string_view beginning, std::string_view bytes, std::size_t piece)
{
    RotctldTalk talk;
    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    const auto tick = [&] {
        (void)talk.go(kTarget);
        const Proof before = talk.proof();
        checkSent(before, talk.send(now));
        require(!hasControlCharacters(talk.strange()) && talk.strange().size() <= 24,
                "what is shown is printable and short");
        if (talk.wantsAnotherLine()) {
            talk.restart();
            require(talk.proof() == Proof::Unknown, "on another line it has to prove itself again");
        }
        now += kTick;
    };
    tick();
    talk.take(beginning, now);
    for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size()))) {
        tick();
        talk.take(bytes.substr(0, piece), now);
        if (const auto places = talk.takePlaces()) {
            require(places->azimuth && places->elevation, "a position has both axes");
            require(talk.proof() == Proof::Box, "who answers is a rotctld");
        }
    }
    talk.stop();
    for (const SteadyTime end = now + std::chrono::seconds(6); now < end;) {
        tick();
    }
}

const std::string kState =
    "dump_state:\nrotctld Protocol Ver: 1\nRotor Model: 1\nMinimum Azimuth: -180.000000\n"
    "Maximum Azimuth: 450.000000\nMinimum Elevation: 0.000000\nMaximum Elevation: 90.000000\nSouth Zero: 0\n"
    "rot_type=AzEl\ndone\nRPRT 0\n";

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    grammar.corpus = {kState,
                      "get_pos:\nAzimuth: 10.00\nElevation: 5.00\nRPRT 0\n",
                      "get_pos:\nRPRT -5\n",
                      "set_pos: 123.00 45.00\nRPRT 0\n",
                      "stop:\nRPRT 0\n",
                      "stop:\nRPRT -11\n",
                      "10.00\n5.00\n",
                      "RPRT 0\n",
                      "RPRT -1\n",
                      "1\n1\nmin_az=-180.0\nmax_az=450.0\nmin_el=0.0\nmax_el=90.0\nsouth_zero=0\nrot_type=AzEl\ndone\n",
                      "0\n1\n-180.000000\n450.000000\n0.000000\n90.000000\n"};
    grammar.tokens = {"Azimuth: ",
                      "Elevation: ",
                      "Minimum ",
                      "Maximum ",
                      "get_pos:",
                      "set_pos:",
                      "stop:",
                      "dump_state:",
                      "min_az=",
                      "max_el=",
                      "rot_type=Az",
                      "done",
                      "RPRT 0",
                      "RPRT -6",
                      "RPRT ",
                      "\n",
                      "\r\n",
                      "0",
                      "1",
                      "-180.000000",
                      "450.00",
                      "1e9",
                      "nan",
                      "inf",
                      "-",
                      ".",
                      "=",
                      ":",
                      "HTTP/1.1 400",
                      "SSH-2.0",
                      "\xff\xfd",
                      std::string(1, '\0'),
                      "\x1b[2J",
                      std::string(LineSplitter::kLongestLine, 'x')};
    grammar.separators = " \r\n=:";
    grammar.maxLength = 600;
    grammar.persistence = 40;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    const std::string_view bytes = asText(input);
    bool understood = false;
    for (const Form form : {Form::Extended, Form::Plain}) {
        for (const Question question : {Question::State, Question::Position, Question::Order, Question::Stop}) {
            understood = checkLines(bytes, question, form) || understood;
        }
    }
    for (const std::string& beginning : {std::string(), kState}) {
        talked(beginning, bytes, bytes.size() + 1);
        talked(beginning, bytes, 7);
    }
    if (understood && bytes.find_first_not_of("\r\n") != std::string_view::npos) {
        accept();
    }
}

}  // namespace boresight::fuzz
