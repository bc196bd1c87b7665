// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue of the alarms is complete: every entry has its sentences, is raised, and is in the manual.
#include "core/alarms/catalogue.h"
#include "core/moteus_mount/drive_alarms.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace boresight {
namespace {

namespace fs = std::filesystem;

using supervision::Observed;
using supervision::Symptom;
using supervision::Weight;

std::string fileText(const fs::path& path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

// The text of all sources that name entries.
std::string sources()
{
    std::string all;
    for (const char* const top : {"core", "ui"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(BORESIGHT_SOURCES) / top)) {
            const bool isSource = entry.path().extension() == ".cpp" || entry.path().extension() == ".h";
            if (const std::string text = isSource ? fileText(entry.path()) : "";
                text.find("alarmEntry(\"") != text.npos) {
                all += text;
            }
        }
    }
    return all;
}

const AlarmEntry* entryNamed(std::string_view id)
{
    const auto all = alarmCatalogue();
    const auto found = std::ranges::find_if(all, [id](const AlarmEntry* entry) { return entry->id == id; });
    return found == all.end() ? nullptr : *found;
}

// The arguments in all its sentences: 1 for "%1".
std::set<int> argumentsOf(const AlarmEntry& entry)
{
    static const std::regex argument("%([1-9])");
    const std::string text = std::string(entry.what) + entry.action + entry.remedy;
    std::set<int> found;
    for (std::sregex_iterator match(text.begin(), text.end(), argument), end; match != end; ++match) {
        found.insert(std::stoi((*match)[1].str()));
    }
    return found;
}

TEST(AlarmCatalogue, EveryEntryHasItsSentencesAndAnIdOfItsOwn)
{
    static const std::regex form("[a-z]+(\\.[a-z-]+)+");
    std::set<std::string> ids;
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        EXPECT_TRUE(ids.insert(entry->id).second) << entry->id;
        EXPECT_TRUE(std::regex_match(entry->id, form)) << entry->id;
        for (const char* const text : {entry->source, entry->what, entry->action, entry->remedy}) {
            EXPECT_NE(std::string_view(text), "") << entry->id;
        }
        EXPECT_LE(entry->severity, entry->worst) << entry->id;
    }
}

TEST(AlarmCatalogue, EveryArgumentHasAnExampleAndIsNamed)
{
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        std::set<int> numbers;
        for (int i = 1; i <= entry->argumentCount(); ++i) {
            numbers.insert(i);
        }
        EXPECT_EQ(argumentsOf(*entry), numbers) << entry->id;
    }
}

TEST(AlarmCatalogue, WhatTakesAPlaceTakesThatOfAnEntryWithOneOfItsOwn)
{
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        const AlarmEntry* const owner = entryNamed(entry->place());
        ASSERT_NE(owner, nullptr) << entry->id;
        EXPECT_EQ(owner->placeOf, nullptr) << entry->id;
        EXPECT_EQ(std::string_view(owner->source), entry->source) << entry->id;
    }
}

TEST(AlarmCatalogue, EveryEntryIsRaisedSomewhere)
{
    static const std::regex notRaised(R"((clear|active)\(\s*alarmEntry\("[^"]*"\))");
    const std::string raising = std::regex_replace(sources(), notRaised, "");
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        EXPECT_NE(raising.find("alarmEntry(\"" + std::string(entry->id) + "\")"), std::string::npos) << entry->id;
    }
}

TEST(AlarmCatalogue, EveryFindingOfTheSupervisionHasEntriesOfItsOwn)
{
    std::set<const AlarmEntry*> seen;
    for (int i = 0; i < supervision::kSymptomCount; ++i) {
        const Observed stop{.symptom = static_cast<Symptom>(i), .weight = Weight::Stop, .what = QStringLiteral("x")};
        const AlarmEntry& entry = drive_alarms::entryOf(stop.symptom);
        EXPECT_TRUE(seen.insert(&entry).second) << entry.id;
        EXPECT_TRUE(entry.of(Axis::Azimuth).sharesPlace(drive_alarms::supervised(stop).entry.of(Axis::Azimuth)));
    }
    for (const Symptom symptom :
         {Symptom::FollowingError, Symptom::Stalled, Symptom::WrongWay, Symptom::MovesUncommanded, Symptom::EncoderJump,
          Symptom::OutsideTravel, Symptom::SupplyLow, Symptom::TorqueGuard}) {
        const AlarmCase alarm =
            drive_alarms::supervised({.symptom = symptom, .weight = Weight::Stop, .what = QStringLiteral("x")});
        EXPECT_EQ(alarm.entry.severity, Severity::Alarm) << alarm.entry.id;
        EXPECT_TRUE(textOf(alarm.entry, alarm.arguments).remedy.endsWith(QStringLiteral("press Re-arm.")))
            << alarm.entry.id;
    }
}

TEST(AlarmCatalogue, SentencesAreFilledWithTheirArguments)
{
    const QStringList arguments{QStringLiteral("azimuth drive"), QStringLiteral("38"), QStringLiteral("100%2 wrong"),
                                QStringLiteral("Look at it. Then press Re-arm")};
    const AlarmText text = textOf(alarmEntry("drive.fault"), arguments);
    EXPECT_EQ(text.what, QStringLiteral("The azimuth drive reports fault 38: 100%2 wrong."));
    EXPECT_EQ(text.brief, QStringLiteral("Fault 38: 100%2 wrong."));
    EXPECT_EQ(text.remedy, QStringLiteral("Look at it. Then press Re-arm."));
    EXPECT_EQ(namedByWhat(alarmEntry("drive.silent"), arguments), QStringList(QStringLiteral("azimuth drive")));
    EXPECT_EQ(
        textOf(alarmEntry("axis.stalled"), {QStringLiteral("x")}).remedy,
        QStringLiteral(
            "Look for what blocks the axis: a cable, a lock, ice or a coupling. Free the axis. Then press Re-arm."));
}

QStringList examplesOf(const AlarmEntry& entry)
{
    QStringList examples;
    for (int i = 0; i < entry.argumentCount(); ++i) {
        examples << QString::fromUtf8(entry.examples[static_cast<std::size_t>(i)]);
    }
    return examples;
}

// REQ-ALARMS-300: An alarm whose remedy names a button or a page has the help that performs this action.
TEST(AlarmCatalogue, ARemedyThatNamesAButtonHasIt)
{
    static const std::pair<const char*, AlarmHelp> kNamed[] = {{"press Re-arm", AlarmHelp::Rearm},
                                                               {"Press Reset stop", AlarmHelp::ResetStop},
                                                               {"Press Unwrap now", AlarmHelp::Unwind},
                                                               {"Press Park now", AlarmHelp::ParkNow},
                                                               {"press Move anyway", AlarmHelp::OverrideWind},
                                                               {"Press Use new time", AlarmHelp::UseNewTime},
                                                               {"press Reconnect", AlarmHelp::Reconnect},
                                                               {"page Protection", AlarmHelp::OpenProtection},
                                                               {"Press Fix", AlarmHelp::OpenProtection},
                                                               {"page Drives", AlarmHelp::OpenDrives},
                                                               {"Open the guide", AlarmHelp::OpenGuide},
                                                               {"page Clients", AlarmHelp::OpenClients},
                                                               {"the limits if", AlarmHelp::OpenLimits},
                                                               {"page North", AlarmHelp::OpenNorth},
                                                               {"page Profile", AlarmHelp::OpenProfile},
                                                               {"in the profile", AlarmHelp::OpenProfile},
                                                               {"the position of the axis", AlarmHelp::ConfirmWrap}};
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        const std::string remedy = textOf(*entry, examplesOf(*entry)).remedy.toStdString();
        for (const auto& [words, help] : kNamed) {
            if (remedy.find(words) != std::string::npos) {
                EXPECT_EQ(entry->help, help) << entry->id << ": " << remedy;
                break;
            }
        }
    }
}

// REQ-ALARMS-301: Each of the three texts of an alarm consists of whole sentences that can be read alone. None contains
// a time that changes.
TEST(AlarmCatalogue, EverySentenceCanBeReadAlone)
{
    static const std::regex runsOn("\\b(in|within|for) [0-9.]+ (s|min|h)\\b");
    static const std::regex done("(was|were|stalled|has sent|has stayed|away|is lost|came|jumped|a jump) ");
    // followed by the duration of the observation
    static const std::regex known("does not move: |moves the wrong way: ");
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        const AlarmText text = textOf(*entry, examplesOf(*entry));
        for (const QString& sentences : {text.what, text.action, text.remedy}) {
            const std::string all = sentences.toStdString();
            EXPECT_TRUE(sentences.endsWith(QLatin1Char('.'))) << entry->id << ": " << all;
            EXPECT_FALSE(sentences.front().isLower()) << entry->id << ": " << all;
            EXPECT_FALSE(sentences.contains(QLatin1Char(';'))) << entry->id << ": " << all;
            EXPECT_FALSE(sentences.contains(QStringLiteral(".."))) << entry->id << ": " << all;
            EXPECT_LE(sentences.count(QStringLiteral(". ")), 2) << entry->id << ": " << all;
            EXPECT_TRUE(!std::regex_search(all, runsOn) || std::regex_search(all, done) ||
                        std::regex_search(all, known))
                << entry->id << ": " << all;
        }
    }
}

// Story: both drives reported fault 40, and each alarm said that the other axis holds.
TEST(AlarmCatalogue, AFaultOfADriveSaysNothingAboutTheOtherAxis)
{
    for (const AlarmEntry& entry : kDriveAlarms) {
        EXPECT_EQ(std::string_view(entry.action).find("The other axis"), std::string_view::npos) << entry.id;
    }
}

// A text from another source can stand alone only if it is a sentence.
// REQ-ALARMS-301
TEST(AlarmCatalogue, WhatHappenedIsNamedUnlessTheReportIsASentence)
{
    static const std::regex whole(
        "(axis|drives)\\..*|journal.in-use|profile.advice|wind\\.(parks|not-parked|overridden)|calibration.other-"
        "mount");
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        EXPECT_TRUE(std::string_view(entry->what) != "%1" || std::regex_match(entry->id, whole)) << entry->id;
    }
}

// With BORESIGHT_ALARM_TABLE set, the table is written into the page with that path.
TEST(AlarmCatalogue, StandsInTheManual)
{
    const std::string table = alarmTable().toStdString();
    const auto introduction = [](const fs::path& path) {
        const std::string page = fileText(path);
        return page.substr(0, page.find("| id |"));
    };
    if (const char* const path = std::getenv("BORESIGHT_ALARM_TABLE"); path != nullptr) {
        const std::string before = introduction(path);
        std::ofstream(path) << before << table;
    }
    const fs::path page = fs::path(BORESIGHT_SOURCES) / "resources/manual/alarms.md";
    EXPECT_NE(introduction(page), "");
    EXPECT_EQ(fileText(page), introduction(page) + table)
        << "BORESIGHT_ALARM_TABLE=resources/manual/alarms.md alarms_test --gtest_filter=AlarmCatalogue.* writes it";
}

}  // namespace
}  // namespace boresight
