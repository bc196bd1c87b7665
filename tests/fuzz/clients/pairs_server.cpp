// SPDX-License-Identifier: GPL-3.0-or-later
// The data of a client that points the mount by plain numbers: any bytes in pieces of any size, with a rotator that
// checks every request.
#include "core/pairs_server/pairs_talk.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fuzz/clients/strict_rotator.h"

#include <algorithm>
#include <string>

namespace boresight::fuzz {
namespace {

using namespace boresight::pairs;

constexpr std::size_t kMaxInput = 600;

// Points and parks.
class PairsRotator final : public StrictRotator
{
public:
    PairsRotator() : StrictRotator({.azimuth = 123.45_deg, .elevation = 67.89_deg}) {}

    Result<> park(const rotctld::Client&) override { return moved(); }
};

bool isAnswer(std::string_view reply)
{
    const QString text = QString::fromUtf8(reply.data(), static_cast<qsizetype>(reply.size()));
    const bool oneLine = text.endsWith(QLatin1Char('\n')) && text.size() < 600 &&
                         std::ranges::all_of(text.chopped(1), [](QChar one) { return one.isPrint(); });
    return oneLine &&
           (reply == kDone || reply == "123.4 67.9\n" || reply == "123.5 67.9\n" || reply.starts_with("error: "));
}

struct Talk
{
    void drain()
    {
        for (bool more = true; more;) {
            std::string reply;
            const int before = rotator.motions;
            more = session->step(reply);
            require(reply.empty() || isAnswer(reply), "an answer is one of the protocol");
            require(!rotator.refuses || reply != kDone, "what is refused is answered so");
            require(rotator.motions - before <= 1, "one line moves once");
            refused = refused || reply.starts_with("error: ");
            answered = answered || !reply.empty();
        }
    }
    void say(std::string_view bytes)
    {
        session->receive(bytes);
        drain();
    }

    fakes::ManualClock clock;
    PairsRotator rotator;
    std::unique_ptr<rotctld::Conversation> session = talkPairs(rotator, clock, [] {
        return std::optional(Site{.latitude = 38.72_deg, .longitude = -9.14_deg});
    })({.id = 7, .address = "/tmp/pairs:5", .protocol = "Pairs"});
    bool refused = false;
    bool answered = false;
};

}  // namespace

// The first byte of an input selects how the rest is cut into pieces, and whether the rotator refuses.
Grammar grammar()
{
    Grammar grammar;
    for (const char cut : {'\0', '\x01', '\x05', '\x83'}) {
        for (const char* const text :
             {"?\n60\n", "120.5 30\n?\n", "+5 0\n+5 -3\n+2\n", "bearing JN58td\nbearing IM58 long\n",
              "stop\r\npark\r\n", "-90 -3\n3600 180\n"}) {
            grammar.corpus.push_back(cut + std::string(text));
        }
    }
    grammar.tokens = {"\n",
                      "\r",
                      " ",
                      "+",
                      "-",
                      "0",
                      "60",
                      "120.5",
                      "3600",
                      "3601",
                      "180.1",
                      "-90",
                      "?",
                      "stop",
                      "park",
                      "bearing ",
                      "JN58td",
                      "ZZ99",
                      " long",
                      "RR99xx99",
                      "AZ EL\n",
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
    Talk talk;
    talk.rotator.refuses = (input[0] & 0x80) != 0;
    const std::size_t piece = (input[0] & 0x7f) == 0 ? input.size() : input[0] & 0x7f;
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
        talk.session->receive("?\n");
        std::string reply;
        while (talk.session->step(reply)) {
        }
        require(isAnswer(reply) && reply.starts_with("error: ") == talk.rotator.refuses,
                "a client is served after any nonsense");
    }
    talk.session->endOfInput();
    talk.drain();
    require(!talk.session->ending().isEmpty(), "a conversation ends with its input");
}

}  // namespace boresight::fuzz
