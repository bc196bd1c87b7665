// SPDX-License-Identifier: GPL-3.0-or-later
// The journal file of a mount (positions and crash stops): gives any bytes to parseJournal(). An accepted journal is
// written and must read back with the same values. No damage may change a value unnoticed.
#include "core/base/control_characters.h"
#include "core/journal/journal_text.h"
#include "tests/fakes/text_of.h"
#include "tests/fuzz/harness.h"

#include <QCryptographicHash>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <numeric>

namespace boresight::fuzz {
namespace {

using namespace boresight::journal;

constexpr std::size_t kJournalMaxInput = 3000;  // a full file has about 1600 bytes

void checkReason(const std::string& reason)
{
    require(!reason.empty() && reason.size() < 300, "a refused journal has a reason of one line");
    require(!hasControlCharacters(reason), "the reason is printable");
}

void checkAccepted(const MountJournal& journal)
{
    for (const auto& turn : journal.turns) {
        require(!turn || (turn->angle.isFinite() && turn->reported.isFinite() && std::isfinite(turn->uptime.count())),
                "a recorded position is finite");
        require(!turn || turn->drive.size() == 36, "a recorded position names its drive");
    }
    for (const auto& stop : journal.crashStops) {
        require(!stop || (stop->angle.isFinite() && stop->rate.isFinite() && stop->time.count() >= 0),
                "a recorded crash stop is finite");
    }
    const auto written = toText(journal);
    require(written.has_value(), "an accepted journal can be written");
    const auto again = parseJournal(*written);
    require(again.has_value(), "a written journal can be read");
    require(*again == journal, "a written journal reads back with the same values");
    require(toText(*again) == written, "writing it again changes nothing");
}

// Changes one bit of the text, selected by the text itself.
void checkDamage(QByteArray text, const MountJournal& journal)
{
    const auto sum = std::accumulate(text.begin(), text.end(), std::size_t{0}, [](std::size_t hash, char byte) {
        return hash * 31 + static_cast<unsigned char>(byte);
    });
    const auto place = static_cast<qsizetype>(sum % static_cast<std::size_t>(text.size()));
    text[place] = static_cast<char>(static_cast<unsigned char>(text[place]) ^ (1U << (sum / 4099 % 7)));
    const auto damaged = parseJournal(text);
    require(!damaged || *damaged == journal, "damage never changes a value unnoticed");
}

MountJournal example()
{
    const UtcTime when = std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} + std::chrono::milliseconds(51825123);
    MountJournal journal;
    journal.turns[0] = TurnRecord{.drive = QStringLiteral("4f2c1a90-11d2-4c6b-9f00-0123456789ab"),
                                  .angle = 370.25_deg,
                                  .reported = MotorTurns::fromTurns(1.0284722),
                                  .uptime = Seconds(8123.456),
                                  .when = when,
                                  .moving = true};
    journal.turns[1] = TurnRecord{.drive = QStringLiteral("00000000-0000-4000-8000-0000000000ff"),
                                  .angle = -0.5_deg,
                                  .reported = MotorTurns::fromTurns(-0.25),
                                  .uptime = Seconds(12.0),
                                  .when = when};
    journal.crashStops[1] = CrashStop{.drive = QStringLiteral("00000000-0000-4000-8000-0000000000ff"),
                                      .rate = 2.5_deg_s,
                                      .angle = 0.75_deg,
                                      .time = std::chrono::milliseconds(431),
                                      .when = when};
    return journal;
}

std::string textOf(const MountJournal& journal)
{
    const auto text = toText(journal);
    require(text.has_value(), "the examples can be written");
    return text->toStdString();
}

// Corrects the checksum, because otherwise no later check would be reached.
void repairChecksum(std::string& text)
{
    QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    if (root.isEmpty()) {
        return;
    }
    const QByteArray payload = QJsonDocument(root[QStringLiteral("memory")].toObject()).toJson(QJsonDocument::Compact);
    const QByteArray sum = QCryptographicHash::hash(payload, QCryptographicHash::Sha256).toHex();
    root[QStringLiteral("checksum")] = QString::fromLatin1(sum);
    text = QJsonDocument(root).toJson().toStdString();
}

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    MountJournal one = example();
    one.turns[1].reset();
    one.crashStops[1].reset();
    grammar.corpus = {textOf(example()), textOf(one), textOf({})};
    grammar.tokens = {"{",
                      "}",
                      "[",
                      "]",
                      ":",
                      ",",
                      "\"",
                      "null",
                      "true",
                      "false",
                      "\\u0000",
                      "\\u001b",
                      "\\",
                      "{}",
                      "[]",
                      "\"\"",
                      "\xc3\xa9",
                      "\xff",
                      std::string("\0", 1),
                      "1e400",
                      "-0.0",
                      "1e-400",
                      "\"2026-11-21T14:23:45.123Z\"",
                      "\"1969-12-31T23:59:59.999Z\"",
                      "\"2200-01-01T00:00:00.001Z\"",
                      "\"2026-02-30T00:00:00.000Z\"",
                      "\"2026-11-21T14:23:45.123+01:00\"",
                      "\"24:00\"",
                      "\"boresight_memory\": 1",
                      "\"boresight_memory\": 2",
                      "\"checksum\": \"\"",
                      "\"azimuth\"",
                      "\"elevation\"",
                      "\"turn\": {}",
                      "\"crash_stop\": {}",
                      "\"moving\": true",
                      "\"home_state\": 2",
                      "\"home_state\": 1.5",
                      "\"4f2c1a90-11d2-4c6b-9f00-0123456789ab\"",
                      "\"angle_rad\": 6283.18531",
                      std::string(1000, '['),
                      std::string(1100, '{')};
    grammar.separators = " \n:,\"{}";
    grammar.maxLength = kJournalMaxInput;
    grammar.persistence = 30;
    grammar.repair = repairChecksum;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    const QByteArray text(reinterpret_cast<const char*>(input.data()), static_cast<qsizetype>(input.size()));
    const auto journal = parseJournal(text);
    if (!journal) {
        checkReason(textOf(journal.error()));
        return;
    }
    accept();
    checkAccepted(*journal);
    checkDamage(text, *journal);
}

}  // namespace boresight::fuzz
