// SPDX-License-Identifier: GPL-3.0-or-later
// The data of a GS-232 client: any bytes in pieces of any size, with a rotator that checks every request.
#include "core/gs232/box_command.h"
#include "core/gs232_server/emulated_box.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fuzz/clients/strict_rotator.h"

#include <algorithm>
#include <array>
#include <string>

namespace boresight::fuzz {
namespace {

using namespace boresight::gs232;

constexpr std::size_t kMaxInput = 600;

// Points and turns with the numbers of a control box, at one of its speeds.
class BoxRotator final : public StrictRotator
{
public:
    BoxRotator() : StrictRotator({.azimuth = 123.45_deg, .elevation = 67.89_deg}) {}

    [[nodiscard]] rotctld::Limits limits() const override { return {0_deg, 450_deg, 0_deg, 180_deg}; }
    Result<QString> pointTo(const rotctld::Client&, const rotctld::PointRequest& request) override
    {
        require(kAzimuthReach.contains(request.azimuth), "an azimuth is within 0°…450°");
        require(kElevationReach.contains(request.elevation), "an elevation is within 0°…180°");
        return moved().map([] { return QString(); });
    }
    Result<> move(const rotctld::Client&, rotctld::MoveDirection, int speed) override
    {
        require(speed == -1, "the speed is that of the level");
        return moved();
    }
    Result<> setSpeedLevel(const rotctld::Client&, int level) override
    {
        require(level >= 1 && level <= 4, "a speed is 1 to 4");
        return outcome();
    }
};

bool isAnswer(std::string_view reply)
{
    constexpr std::array<std::string_view, 8> kAnswers{
        "\r", "?>\r\n", "+0123\r\n", "+0068\r\n", "+0123+0068\r\n", "AZ=123\r\n", "EL=068\r\n", "AZ=123  EL=068\r\n"};
    return std::ranges::find(kAnswers, reply) != kAnswers.end();
}

struct Talk
{
    explicit Talk(Dialect dialect)
        : session(talkGs232(rotator, clock, dialect)({.id = 7, .address = "127.0.0.1:5", .protocol = "GS-232"}))
    {}

    void drain()
    {
        for (bool more = true; more;) {
            std::string reply;
            const int before = rotator.motions;
            more = session->step(reply);
            require(reply.empty() || isAnswer(reply), "an answer is one of the protocol");
            require(!rotator.refuses || reply.empty() || reply == kRefusal, "what is refused is answered so");
            require(rotator.motions - before <= 1, "one command moves once");
            refused = refused || reply == kRefusal;
            answered = answered || !reply.empty();
        }
    }
    void say(std::string_view bytes)
    {
        session->receive(bytes);
        drain();
    }

    fakes::ManualClock clock;
    BoxRotator rotator;
    std::unique_ptr<rotctld::Conversation> session;
    bool refused = false;
    bool answered = false;
};

}  // namespace

// The first byte of an input selects how the rest is cut into pieces, the dialect, and whether the rotator refuses.
Grammar grammar()
{
    Grammar grammar;
    for (const char cut : {'\0', '\x01', '\x05', '\x43', '\x83'}) {
        for (const char* const text : {"C2\r", "W123 046\r\r", "X2\r\rD\r\r", "M090\rC\rB\rS\r", "L\r\nA\r\nE\r\n",
                                       "W010 123 045 130 050\rT\rN\r", "O2\rF2\rP45\rZ\rH\r"}) {
            grammar.corpus.push_back(cut + std::string(text));
        }
    }
    grammar.tokens = {"\r",
                      "\n",
                      " ",
                      "C",
                      "C2",
                      "B",
                      "W",
                      "M",
                      "123 045",
                      "450 180",
                      "451 181",
                      "S",
                      "A",
                      "E",
                      "R",
                      "L",
                      "U",
                      "D",
                      "X1",
                      "X4",
                      "X5",
                      "?>",
                      "AZ EL \n",
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
    Talk talk((input[0] & 0x40) != 0 ? Dialect::B : Dialect::A);
    talk.rotator.refuses = (input[0] & 0x80) != 0;
    const std::size_t piece = (input[0] & 0x3f) == 0 ? input.size() : input[0] & 0x3f;
    for (std::string_view rest = asText(input.subspan(1)); !rest.empty() && talk.session->ending().isEmpty();
         rest.remove_prefix(std::min(piece, rest.size()))) {
        talk.say(rest.substr(0, piece));
    }
    if (talk.answered && !talk.refused && !talk.session->midCommand()) {
        accept();
    }
    if (talk.session->ending().isEmpty()) {
        talk.say("\r");
    }
    if (talk.session->ending().isEmpty()) {
        talk.session->receive("C\r");
        std::string reply;
        while (talk.session->step(reply)) {
        }
        require(isAnswer(reply) && (talk.rotator.refuses || reply != kRefusal),
                "a client is served after any nonsense");
    }
    talk.session->endOfInput();
    talk.drain();
    require(!talk.session->ending().isEmpty(), "a conversation ends with its input");
}

}  // namespace boresight::fuzz
