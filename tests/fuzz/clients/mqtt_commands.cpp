// SPDX-License-Identifier: GPL-3.0-or-later
// Messages on the command topics of a broker: any bytes, kept by the broker or not, on either topic, with a rotator
// that checks every request.
#include "core/mqtt_commands/command_talk.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fuzz/clients/strict_rotator.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <string>

namespace boresight::fuzz {
namespace {

using namespace boresight::mqtt;

constexpr std::size_t kMaxMessage = 600;

// Points and parks.
class CommandedRotator final : public StrictRotator
{
public:
    CommandedRotator() : StrictRotator({.azimuth = 123.45_deg, .elevation = 67.89_deg}) {}

    Result<> park(const rotctld::Client&) override { return moved(); }
};

// The conditions that the first byte of an input selects.
struct Chance
{
    explicit Chance(std::uint8_t bits)
        : isKept((bits & 0x01) != 0),
          isForStop((bits & 0x02) != 0),
          readsOnly((bits & 0x04) != 0),
          refuses((bits & 0x08) != 0),
          isEarly((bits & 0x10) != 0)
    {}
    [[nodiscard]] bool mayMove() const { return !isKept && !readsOnly && !isEarly; }

    bool isKept;
    bool isForStop;
    bool readsOnly;
    bool refuses;
    bool isEarly;
};

QJsonObject checked(const std::optional<QByteArray>& answer)
{
    require(answer.has_value(), "a command is answered");
    const QJsonObject all = QJsonDocument::fromJson(*answer).object();
    const QString text = all[QStringLiteral("answer")].toString();
    require(!text.isEmpty() && text.toUtf8().size() < 600, "an answer is short");
    require(std::ranges::all_of(*answer, [](char one) { return static_cast<unsigned char>(one) >= 0x20; }),
            "an answer is one line");
    require(std::ranges::all_of(text, [](QChar one) { return one.isPrint(); }), "an answer is printable");
    require(all[QStringLiteral("ok")].toBool() != text.startsWith(QLatin1String("error: ")),
            "a refusal gives a reason");
    return all;
}

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    for (const char choice : {'\0', '\0', '\0', '\x01', '\x02', '\x04', '\x08', '\x10'}) {
        for (const char* const text : {"?", "60", "120.5 30\n", "+5 -3", "bearing JN58td", "bearing IM58 long",
                                       "stop\r\n", "hold", "park", "-90 -3", "3600 180"}) {
            grammar.corpus.push_back(choice + std::string(text));
        }
    }
    grammar.tokens = {"\n",     "\r",    " ",     "+",         "-",     "0",        "60",   "120.5",
                      "3601",   "180.1", "?",     "stop",      " stop", "hold",     "park", "bearing ",
                      "JN58td", "ZZ99",  " long", "{\"a\":1}", "PRESS", "\xff\xfb", "\x80", std::string("\0", 1)};
    grammar.separators = " \n\r";
    grammar.maxLength = kMaxMessage;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    if (input.empty()) {
        return;
    }
    const Chance chance(input[0]);
    const std::string_view text = asText(input.subspan(1));
    const QByteArray message(text.data(), static_cast<qsizetype>(text.size()));
    fakes::ManualClock clock;
    CommandedRotator rotator;
    rotator.refuses = chance.refuses;
    int stops = 0;
    CommandTalk talk(
        {.id = 7, .address = "topic boresight/command", .protocol = "MQTT", .readsOnly = chance.readsOnly}, rotator,
        clock, [] { return std::optional(Site{.latitude = 38.72_deg, .longitude = -9.14_deg}); },
        [&](const rotctld::Client&) {
            ++stops;
            return Result<>{};
        });
    clock.advance(chance.isEarly ? Seconds(1.0) : Seconds(3.0));
    const Retain retain = chance.isKept ? Retain::Yes : Retain::No;
    const QJsonObject answer = checked(chance.isForStop ? talk.stop(message, retain) : talk.obey(message, retain));
    const bool isAccepted = answer[QStringLiteral("ok")].toBool();
    require(chance.mayMove() || rotator.motions == 0, "nothing moves that may not");
    require(rotator.motions + stops <= 1, "one message is one command");
    require(!chance.isKept || (stops == 0 && !isAccepted), "what the broker kept is never obeyed");
    require(chance.isKept || !chance.isForStop || stops == 1, "the topic for STOP stops");
    require(!chance.refuses || !isAccepted || stops == 1, "what is refused is answered so");
    if (isAccepted) {
        accept();
    }
    clock.advance(Seconds(2.0));
    const QJsonObject next = checked(talk.obey("?", Retain::No));
    require(next[QStringLiteral("ok")].toBool() != chance.refuses, "the next command is served");
    (void)checked(talk.obey("stop", Retain::No));
    require(stops >= 1, "STOP works after any nonsense");
}

}  // namespace boresight::fuzz
