// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/journal_text.h"

#include "tests/core/journal/example_journal.h"
#include "tests/fakes/text_of.h"

#include <QCryptographicHash>
#include <QJsonDocument>
#include <QJsonObject>

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <ostream>
#include <random>

namespace boresight::journal {
namespace {

using testing::HasSubstr;

std::string problemOf(const QByteArray& text)
{
    const auto parsed = parseJournal(text);
    return parsed ? "accepted" : textOf(parsed.error());
}

// REQ-MEMORY-01: A written journal reads back the same: doubles to the last bit, times to the millisecond. A value that
// could not be read back is not written.
TEST(JournalText, SurvivesTheRoundTripExactly)
{
    for (const MountJournal& journal : {MountJournal(), exampleJournal()}) {
        const auto text = toText(journal);
        ASSERT_TRUE(text);
        const auto parsed = parseJournal(*text);
        ASSERT_TRUE(parsed) << textOf(parsed.error());
        EXPECT_EQ(*parsed, journal);
    }
}

// An older file must stay readable, although it proves nothing without an origin. Version 1 wrote this file. Another
// SHA-256 program computed its checksum over the sorted compact JSON.
TEST(JournalText, ReadsAFileOfVersionOne)
{
    const QByteArray text = R"({
    "boresight_memory": 1,
    "checksum": "50f93fa7fa7991b05441aafde2475b8b9576eaf512d53a257702dd40b586550f",
    "memory": {
        "azimuth": {
            "crash_stop": {
                "angle_rad": 0.0125,
                "drive": "6f1c2a90-0b7d-4e11-8c55-0123456789ab",
                "rate_rad_s": 0.03125,
                "time_ms": 183,
                "when": "2026-11-21T12:00:00.345Z"
            },
            "turn": {
                "angle_rad": 7.0625,
                "counted_rad": 0.75,
                "drive": "6f1c2a90-0b7d-4e11-8c55-0123456789ab",
                "home_state": 2,
                "host_boot": "0d5c1b1e-7a52-4b7c-a1ea-3f1f6d1f7f10",
                "host_since_boot_s": 5000.5,
                "host_utc_is_exact": false,
                "moving": true,
                "reported_turns": 1.125,
                "uptime_s": 34.5,
                "when": "2026-11-21T12:00:00.345Z"
            }
        },
        "elevation": {
        }
    }
})";
    const auto parsed = parseJournal(text);
    ASSERT_TRUE(parsed) << textOf(parsed.error());
    const TurnRecord turn{.drive = kAzimuthDrive,
                          .angle = Angle::fromRadians(7.0625),
                          .reported = MotorTurns::fromTurns(1.125),
                          .counted = Angle::fromRadians(0.75),
                          .uptime = Seconds(34.5),
                          .homeState = moteus::HomeState::Output,
                          .when = kWhen,
                          .host = {.boot = kBoot, .sinceBoot = Seconds(5000.5)},
                          .moving = true};
    const CrashStop stop{.drive = kAzimuthDrive,
                         .rate = AngularRate::fromRadians(0.03125),
                         .angle = Angle::fromRadians(0.0125),
                         .time = std::chrono::milliseconds(183),
                         .when = kWhen};
    EXPECT_EQ(parsed->turns[0], turn);
    EXPECT_EQ(parsed->crashStops[0], stop);
    EXPECT_FALSE(parsed->turns[1]);
    EXPECT_FALSE(parsed->crashStops[1]);
}

// An older file is written back the same, to the last byte.
TEST(JournalText, KeepsTheFormOfItsFile)
{
    std::ifstream file(BORESIGHT_TEST_DATA "/memory.json");
    const std::string kept{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(toText(exampleJournal())->toStdString(), kept);
    const auto parsed = parseJournal(QByteArray::fromStdString(kept));
    ASSERT_TRUE(parsed) << textOf(parsed.error());
    EXPECT_EQ(*parsed, exampleJournal());
}

// REQ-MEMORY-01
TEST(JournalText, KeepsEveryDoubleToTheLastBit)
{
    std::mt19937_64 random(3);
    for (int i = 0; i < 5000; ++i) {
        const double value = std::bit_cast<double>(random());
        if (!std::isfinite(value) || std::abs(value) > 6000.0) {
            continue;
        }
        MountJournal journal = exampleJournal();
        journal.turns[0]->angle = Angle::fromRadians(value);
        journal.turns[0]->reported = MotorTurns::fromTurns(-value);
        journal.turns[0]->uptime = Seconds(std::abs(value));
        const auto parsed = toText(journal).and_then(parseJournal);
        ASSERT_TRUE(parsed) << value << ": " << textOf(parsed.error());
        ASSERT_EQ(*parsed, journal) << value;
    }
}

TEST(JournalText, TimesAreUtcToTheMillisecond)
{
    MountJournal journal = exampleJournal();
    journal.turns[0]->when += std::chrono::microseconds(999);
    const auto text = toText(journal);
    ASSERT_TRUE(text);
    EXPECT_THAT(text->toStdString(), HasSubstr("\"2026-11-21T12:00:00.345Z\""));
    EXPECT_EQ(parseJournal(*text)->turns[0]->when, kWhen);
}

// REQ-MEMORY-02: A file that is empty, incomplete, edited, of another version or out of range is detected, with the
// reason. It is never taken for a valid one.
TEST(JournalText, TellsWhyAFileIsOfNoUse)
{
    const QByteArray good = *toText(exampleJournal());
    EXPECT_EQ(problemOf(""), "it is empty");
    EXPECT_EQ(problemOf(QByteArray(4096, '\0')), "it is empty");
    EXPECT_THAT(problemOf(good.left(good.size() / 2)), HasSubstr("it is damaged at byte"));
    EXPECT_EQ(problemOf("{}"), "it is not a position journal");
    EXPECT_EQ(problemOf("[1, 2]"), "it is not a position journal");
    EXPECT_EQ(problemOf(QByteArray(good).replace("\"boresight_memory\": 1", "\"boresight_memory\": 2")),
              "it has version 2, but this program reads version 1");
    EXPECT_EQ(problemOf(QByteArray(good).replace("1234.567", "1234.568")),
              "its checksum is wrong, so it was changed or damaged");
    EXPECT_EQ(problemOf(QByteArray(good).replace("\"moving\": true", "\"moving\": false")),
              "its checksum is wrong, so it was changed or damaged");
    EXPECT_EQ(problemOf(QByteArray(good).replace("\"memory\"", "\"Memory\"")),
              "its checksum is wrong, so it was changed or damaged");
}

TEST(JournalText, SpacesDoNotCount)
{
    const QByteArray compact = QJsonDocument::fromJson(*toText(exampleJournal())).toJson(QJsonDocument::Compact);
    EXPECT_EQ(*parseJournal(compact), exampleJournal());
}

struct Broken
{
    const char* name;
    std::function<void(MountJournal&)> change;
    const char* reason;

    friend void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.name; }
};

class JournalTextRefuses : public testing::TestWithParam<Broken>
{};

// Refused at the time of writing, so that the good file stays. A written file can always be read.
// REQ-MEMORY-01 (JournalTextRefuses.*)
TEST_P(JournalTextRefuses, WhatNoAxisCanBe)
{
    MountJournal journal = exampleJournal();
    GetParam().change(journal);
    const auto text = toText(journal);
    ASSERT_FALSE(text);
    EXPECT_EQ(textOf(text.error()), GetParam().reason);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

INSTANTIATE_TEST_SUITE_P(
    All, JournalTextRefuses,
    testing::Values(
        Broken{"NotANumber", [](MountJournal& m) { m.turns[0]->angle = Angle::fromRadians(kNan); },
               "azimuth.turn.angle_rad is not finite"},
        Broken{"Infinite", [](MountJournal& m) { m.turns[1]->reported = MotorTurns::fromTurns(kInfinity); },
               "elevation.turn.reported_turns is not finite"},
        Broken{"AngleTooLarge", [](MountJournal& m) { m.turns[0]->angle = Angle::fromTurns(-1001.0); },
               "azimuth.turn.angle_rad is out of range"},
        Broken{"CountTooLarge", [](MountJournal& m) { m.turns[0]->reported = MotorTurns::fromTurns(32769.0); },
               "azimuth.turn.reported_turns is out of range"},
        Broken{"UptimeNegative", [](MountJournal& m) { m.turns[0]->uptime = Seconds(-1.0); },
               "azimuth.turn.uptime_s is out of range"},
        Broken{"UptimeBeyondTheCounter", [](MountJournal& m) { m.turns[0]->uptime = Seconds(4294968.0); },
               "azimuth.turn.uptime_s is out of range"},
        Broken{"HomeState", [](MountJournal& m) { m.turns[0]->homeState = static_cast<moteus::HomeState>(3); },
               "azimuth.turn.home_state is out of range"},
        Broken{"OriginNotANumber", [](MountJournal& m) { m.turns[0]->origin->offset = MotorTurns::fromTurns(kNan); },
               "azimuth.turn.origin_offset_turns is not finite"},
        Broken{"OriginOfNowhere", [](MountJournal& m) { m.turns[0]->origin->beginning = 1U << 24; },
               "azimuth.turn.origin_beginning is out of range"},
        Broken{"NoDrive", [](MountJournal& m) { m.turns[0]->drive.clear(); },
               "azimuth.turn.drive is not of the form 8-4-4-4-12 digits"},
        Broken{"StrangeDrive", [](MountJournal& m) { m.crashStops[1]->drive[3] = u'g'; },
               "elevation.crash_stop.drive is not of the form 8-4-4-4-12 digits"},
        Broken{"StrangeBoot", [](MountJournal& m) { m.turns[0]->host.boot = QStringLiteral("\n"); },
               "azimuth.turn.host_boot is not of the form 8-4-4-4-12 digits"},
        Broken{"BeforeAllClocks", [](MountJournal& m) { m.turns[0]->when = UtcTime() - std::chrono::hours(1); },
               "azimuth.turn.when is not a UTC time from 1970 to 2200"},
        Broken{"RateTooLarge", [](MountJournal& m) { m.crashStops[1]->rate = AngularRate::fromTurns(101.0); },
               "elevation.crash_stop.rate_rad_s is out of range"},
        Broken{"StopTooLong", [](MountJournal& m) { m.crashStops[1]->time = std::chrono::hours(2); },
               "elevation.crash_stop.time_ms is out of range"}),
    [](const testing::TestParamInfo<Broken>& test) { return test.param.name; });

class JournalTextRubbish : public testing::Test
{
protected:
    [[nodiscard]] std::size_t below(std::size_t end)
    {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(m_random);
    }
    [[nodiscard]] char byte() { return static_cast<char>(below(256)); }

    [[nodiscard]] QByteArray damaged(QByteArray text)
    {
        const auto place = [&] { return static_cast<qsizetype>(below(static_cast<std::size_t>(text.size()))); };
        switch (below(7)) {
            case 0:  // a character from another place, with one bit changed
                text[place()] = static_cast<char>(text.at(place()) ^ (1 << below(8)));
                return text;
            case 1: {  // one bit changed
                const qsizetype i = place();
                text[i] = static_cast<char>(text.at(i) ^ (1 << below(8)));
                return text;
            }
            case 2:  // cut off
                return text.left(place());
            case 3: {  // the end is zeros, as after a power cut
                const qsizetype end = place();
                return text.left(end) + QByteArray(text.size() - end, '\0');
            }
            case 4:  // one digit replaced by another
                text[place()] = static_cast<char>('0' + below(10));
                return text;
            case 5: {  // a part of it twice
                const qsizetype from = place();
                return text.insert(place(), text.mid(from, static_cast<qsizetype>(below(40))));
            }
            default: {
                QByteArray rubbish(static_cast<qsizetype>(below(300)), '\0');
                for (char& c : rubbish) {
                    c = byte();
                }
                return rubbish;
            }
        }
    }

    std::mt19937_64 m_random{2026};
};

// REQ-MEMORY-02 (JournalTextRubbish.*)
TEST_F(JournalTextRubbish, IsNeverAcceptedAsSomethingElse)
{
    const MountJournal journal = exampleJournal();
    const QByteArray good = *toText(journal);
    int refused = 0;
    for (int i = 0; i < 20000; ++i) {
        const QByteArray text = damaged(good);
        const auto parsed = parseJournal(text);
        refused += parsed ? 0 : 1;
        ASSERT_TRUE(!parsed || *parsed == journal) << text.toStdString();
        ASSERT_TRUE(parsed || !textOf(parsed.error()).empty());
    }
    EXPECT_GT(refused, 14000);  // the other cases changed a space, or put the same character there
}

// An editor who also corrects the checksum passes that check. Then the fields are checked one by one.
TEST_F(JournalTextRubbish, WithTheRightChecksumIsStillChecked)
{
    const QByteArray good = *toText(exampleJournal());
    const QByteArray from = "\"angle_rad\": ";
    for (const char* value : {"null", "\"7\"", "1e300", "[]", "true"}) {
        QByteArray changed = good;
        const qsizetype start = changed.indexOf(from) + from.size();
        changed.replace(start, changed.indexOf(',', start) - start, value);
        const QJsonObject payload = QJsonDocument::fromJson(changed).object().value(QLatin1String("memory")).toObject();
        const QByteArray sum =
            QCryptographicHash::hash(QJsonDocument(payload).toJson(QJsonDocument::Compact), QCryptographicHash::Sha256)
                .toHex();
        const qsizetype place = changed.indexOf("\"checksum\": \"") + 13;
        changed.replace(place, 64, sum);
        EXPECT_THAT(problemOf(changed), HasSubstr(".angle_rad is ")) << value;
    }
}

}  // namespace
}  // namespace boresight::journal
