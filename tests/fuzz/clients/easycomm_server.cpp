// SPDX-License-Identifier: GPL-3.0-or-later
// The data of an EasyComm client: any bytes in pieces of any size, with a rotator that checks every request.
#include "core/base/version.h"
#include "core/easycomm_server/easycomm_controller.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fuzz/clients/strict_rotator.h"

#include <algorithm>
#include <array>
#include <string>

namespace boresight::fuzz {
namespace {

using namespace boresight::easycomm;

constexpr std::size_t kMaxInput = 600;

// Turns at any rate without a speed level, parks and re-arms.
class EasycommRotator final : public StrictRotator
{
public:
    EasycommRotator() : StrictRotator({.azimuth = 123.45_deg, .elevation = -0.31_deg}) {}

    Result<> move(const rotctld::Client&, rotctld::MoveDirection, int speed) override
    {
        require(speed == -1, "the speed is that of the level");
        return moved();
    }
    Result<QString> moveAt(const rotctld::Client&, rotctld::MoveDirection, AngularRate rate) override
    {
        require(rate > AngularRate{} && rate < 1000.0_deg_s, "a rate has at most six digits and is above zero");
        return moved().map([] { return QString(); });
    }
    Result<> park(const rotctld::Client&) override { return moved(); }
    Result<> reset(const rotctld::Client&, int kind) override
    {
        require(kind == 1, "a reset is of all");
        return moved();
    }
};

bool isAlarm(std::string_view word)
{
    constexpr std::array<std::string_view, 5> kAlarms{"ALnot-understood", "ALoutside-limits", "ALnot-supported",
                                                      "ALrefused", "ALno-position"};
    return std::ranges::find(kAlarms, word) != kAlarms.end();
}

bool isAnswer(std::string_view word)
{
    constexpr std::array<std::string_view, 6> kAnswers{"AZ123.5", "EL-0.3", "GS1", "GS8", "GE0", "GE1"};
    return std::ranges::find(kAnswers, word) != kAnswers.end() || word == "VEBoresight-" + std::string(kVersion);
}

// An alarm, or answers separated by one blank.
bool isLine(std::string_view line)
{
    if (isAlarm(line)) {
        return true;
    }
    for (std::size_t end = line.find(' '); end != std::string_view::npos; end = line.find(' ')) {
        if (!isAnswer(line.substr(0, end))) {
            return false;
        }
        line.remove_prefix(end + 1);
    }
    return isAnswer(line);
}

struct Talk
{
    explicit Talk(Version version)
        : session(talkEasycomm(rotator, clock, version)({.id = 7, .address = "127.0.0.1:5", .protocol = "EasyComm"}))
    {}

    void drain()
    {
        for (bool more = true; more;) {
            std::string reply;
            const int before = rotator.motions;
            more = session->step(reply);
            require(rotator.motions - before <= 1, "one line moves once");
            answered = answered || !reply.empty();
            refused = refused || reply.starts_with("AL");
            std::string_view rest = reply;
            for (int lines = 0; !rest.empty(); ++lines) {
                require(lines < 2 && rest.find('\n') != std::string_view::npos, "an alarm and answers, whole lines");
                require(isLine(rest.substr(0, rest.find('\n'))), "an answer is one of the protocol");
                rest.remove_prefix(rest.find('\n') + 1);
            }
        }
    }
    void say(std::string_view bytes)
    {
        session->receive(bytes);
        drain();
    }

    fakes::ManualClock clock;
    EasycommRotator rotator;
    std::unique_ptr<rotctld::Conversation> session;
    bool refused = false;
    bool answered = false;
};

}  // namespace

// The first byte of an input selects how the rest is cut into pieces, the version, and whether the rotator refuses.
Grammar grammar()
{
    Grammar grammar;
    for (const char cut : {'\0', '\x01', '\x05', '\x23', '\x43', '\x83', '\xc5'}) {
        for (const char* const text : {"AZ EL \n", "AZ123.4 EL45.6\nAZ\nEL\n", "AZ1.0 EL2.0 UP000 XXX DN000 XXX\n",
                                       "MR\nMU\nSA SE \n", "VL0500\nVU0000\nGS\n;GE\n;VE\n;",
                                       "PARK\r\nRESET\r\nAZ370.0\r\nEL-1,5\r\n", "CW0,100\n;CR 0\nIP1\nOP1,1\n"}) {
            grammar.corpus.push_back(cut + std::string(text));
        }
    }
    grammar.tokens = {"\n",
                      "\r",
                      " ",
                      ";",
                      "AZ",
                      "EL",
                      "AZ EL ",
                      "123.4",
                      "-0.0",
                      "3600",
                      "3601",
                      "180.1",
                      "UP145900000 FM",
                      "DN000 CW",
                      "SA",
                      "SE",
                      "STOP",
                      "ML",
                      "MD",
                      "VR",
                      "VD9999",
                      "PARK",
                      "RESET",
                      "VE",
                      "GS",
                      "GE",
                      "CR",
                      "IP",
                      "W123 045\r",
                      "\\get_pos\n",
                      "GET / HTTP/1.1\r\n",
                      "\x16\x03",
                      std::string("\0", 1),
                      "\x80",
                      "\xff\xfb"};
    grammar.separators = " \n\r";
    grammar.maxLength = kMaxInput;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    if (input.empty()) {
        return;
    }
    constexpr std::array kVersions{Version::Two, Version::One, Version::Three, Version::Three};
    Talk talk(kVersions.at((input[0] >> 5U) & 3U));
    talk.rotator.refuses = (input[0] & 0x80) != 0;
    const std::size_t piece = (input[0] & 0x1f) == 0 ? input.size() : input[0] & 0x1f;
    for (std::string_view rest = asText(input.subspan(1)); !rest.empty() && talk.session->ending().isEmpty();
         rest.remove_prefix(std::min(piece, rest.size()))) {
        talk.say(rest.substr(0, piece));
    }
    if (talk.answered && !talk.refused && !talk.session->midCommand()) {
        accept();
    }
    if (talk.session->ending().isEmpty()) {
        talk.say("\n");
    }
    if (talk.session->ending().isEmpty()) {
        talk.session->receive("AZ EL \n");
        std::string reply;
        while (talk.session->step(reply)) {
        }
        require(reply == (talk.rotator.refuses ? "ALno-position\n" : "AZ123.5 EL-0.3\n"),
                "a client is served after any nonsense");
    }
    talk.session->endOfInput();
    talk.drain();
    require(!talk.session->ending().isEmpty(), "a conversation ends with its input");
}

}  // namespace boresight::fuzz
