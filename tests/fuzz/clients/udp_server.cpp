// SPDX-License-Identifier: GPL-3.0-or-later
// Datagrams to the UDP control of PstRotator and from N1MM Logger+: any bytes, also while a command may be old, with a
// rotator that checks every request.
#include "core/udp_server/n1mm_words.h"
#include "core/udp_server/pst_words.h"
#include "core/udp_server/udp_controller.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fuzz/clients/strict_rotator.h"

#include <algorithm>
#include <array>
#include <string>

namespace boresight::fuzz {
namespace {

using namespace boresight::udp;

constexpr std::size_t kMaxDatagram = 600;

// Points, parks and stops.
class DatagramRotator final : public StrictRotator
{
public:
    DatagramRotator() : StrictRotator({.azimuth = 123.4_deg, .elevation = 67.8_deg}) {}

    Result<> park(const rotctld::Client&) override { return moved(); }
    Result<> stop(const rotctld::Client&) override
    {
        ++stopCount;
        return outcome();
    }

    int stopCount = 0;
};

// What the first byte of an input selects.
struct Chance
{
    explicit Chance(std::uint8_t bits)
        : isN1mm((bits & 0x01) != 0),
          isNamed((bits & 0x02) != 0),
          refuses((bits & 0x04) != 0),
          isEarly((bits & 0x08) != 0)
    {}
    [[nodiscard]] Parse parse() const
    {
        const std::string rotor = isNamed ? "Yagi 20" : "";
        return isN1mm ? Parse([rotor](std::string_view datagram) { return parseN1mm(datagram, rotor); }) : parsePst;
    }

    bool isN1mm;
    bool isNamed;
    bool refuses;
    bool isEarly;
};

bool isAnswer(std::string_view reply)
{
    constexpr std::array<std::string_view, 3> kAnswers{"AZ:123.4\r", "EL:67.8\r", "TGA:123.4\r"};
    return std::ranges::find(kAnswers, reply) != kAnswers.end();
}

// A stop of N1MM without the name of a rotor: it is empty, a value or has other fields.
bool isNamelessStop(std::string_view datagram)
{
    constexpr std::string_view kStop = "<stop>";
    const std::size_t stop = datagram.find(kStop);
    if (stop == std::string_view::npos || datagram.find("<rotor>") != std::string_view::npos) {
        return false;
    }
    const std::string_view content = datagram.substr(stop + kStop.size());
    return content.starts_with('<') || content.starts_with("0<") || content.starts_with("1<");
}

bool mustStop(std::string_view datagram, const Chance& chance)
{
    if (!chance.isN1mm) {
        return datagram.find("<STOP>1</STOP>") != std::string_view::npos ||
               datagram.find("<STOP> 1\n</STOP>") != std::string_view::npos;
    }
    return datagram.find("<N1MMRotor>") != std::string_view::npos &&
           (chance.isNamed ? isNamelessStop(datagram) : datagram.find("<stop>") != std::string_view::npos);
}

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    for (const char choice : {'\0', '\0', '\0', '\0', '\x04', '\x08'}) {
        for (const char* const text :
             {"<PST><AZIMUTH>85</AZIMUTH></PST>", "<PST><ELEVATION>15.250000.2</ELEVATION></PST>", "<PST>AZ?</PST>\n",
              "<PST><TRACK>0</TRACK><AZIMUTH>123,4</AZIMUTH><ELEVATION>5.6</ELEVATION></PST>", "<PST>TGA?</PST>",
              "<PST><STOP>1</STOP></PST>", "x<STOP> 1\n</STOP>", "<PST><PARK>1</PARK></PST>", "<pst>el?</pst>"}) {
            grammar.corpus.push_back(choice + std::string(text));
        }
    }
    for (const char choice : {'\x01', '\x01', '\x03', '\x05', '\x09'}) {
        for (const char* const text :
             {"<N1MMRotor><rotor>Yagi 20</rotor><goazi>55.5</goazi><offset>0.0</offset>"
              "<bidirectional>0</bidirectional><freqband>14</freqband></N1MMRotor>",
              "<?xml version=\"1.0\"?>\r\n<N1MMRotor>\r\n<goazi>222,5</goazi>\r\n</N1MMRotor>\r\n",
              "<N1MMRotor><stop><rotor>Yagi 20</rotor><freqband>21.0</freqband></stop></N1MMRotor>",
              "<N1MMRotor><stop><freqband>21.0</freqband></stop></N1MMRotor>",
              "<N1MMRotor><stop>1</stop></N1MMRotor>"}) {
            grammar.corpus.push_back(choice + std::string(text));
        }
    }
    grammar.tokens = {"<PST>",       "</PST>",
                      "<AZIMUTH>",   "</AZIMUTH>",
                      "<ELEVATION>", "</ELEVATION>",
                      "<STOP>",      "</STOP>",
                      "<PARK>",      "</PARK>",
                      "<TRACK>",     "</TRACK>",
                      "<QRA>",       "AZ?",
                      "EL?",         "TGA?",
                      "<N1MMRotor>", "</N1MMRotor>",
                      "<goazi>",     "</goazi>",
                      "<offset>",    "</offset>",
                      "<rotor>",     "</rotor>",
                      "<stop>",      "</stop>",
                      "<freqband>",  "</freqband>",
                      "0",           "1",
                      "360.0",       "3601",
                      "-90.1",       "nan",
                      "1e9",         "85.000000.2",
                      "<!ENTITY ",   "&#56;",
                      "&amp;",       "<![CDATA[",
                      "]]>",         "<?xml ",
                      "?>",          "\xff\xfb",
                      "\x80",        std::string("\0", 1)};
    grammar.separators = "<>\n";
    grammar.maxLength = kMaxDatagram;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    if (input.empty()) {
        return;
    }
    const Chance chance(input[0]);
    const std::string_view datagram = asText(input.subspan(1));
    const Parse parse = chance.parse();
    fakes::ManualClock clock;
    DatagramRotator rotator;
    rotator.refuses = chance.refuses;
    rotctld::Settling settling(clock);
    UdpController controller({.id = 7, .address = "127.0.0.1:5", .protocol = "PstRotator"},
                             {.rotator = rotator, .parse = parse, .settling = settling, .clock = clock});
    if (chance.isEarly) {
        settling.begin();
    }
    const rotctld::LineOutcome outcome = controller.obey(datagram);
    require(rotator.motions + rotator.stopCount <= 1, "one datagram is one command");
    require(!chance.isEarly || rotator.motions == 0, "nothing moves while a command may be old");
    require(datagram.size() <= UdpController::kLongest || rotator.motions == 0,
            "a datagram that is too long moves nothing");
    require(!mustStop(datagram, chance) || rotator.stopCount == 1, "a stop is obeyed in any datagram");
    require(outcome.reply.empty() || (isAnswer(outcome.reply) && !chance.isN1mm && !chance.refuses),
            "only a question with a known answer is answered");
    require(outcome.reply.size() <= datagram.size(), "an answer is not longer than its question");
    require(outcome.result || (!outcome.result.error().text.isEmpty() && outcome.result.error().text.size() < 300),
            "a refusal has a short reason");
    require(!chance.refuses || rotator.motions + rotator.stopCount == 0 || !outcome.result, "a refusal is passed on");
    if (outcome.result && (rotator.motions + rotator.stopCount > 0 || !outcome.reply.empty())) {
        accept();
    }
    const int before = rotator.stopCount;
    (void)controller.obey(chance.isN1mm ? "<N1MMRotor><stop></stop></N1MMRotor>" : "<PST><STOP>1</STOP></PST>");
    require(rotator.stopCount == before + 1, "a stop is obeyed after any nonsense");
}

}  // namespace boresight::fuzz
