// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/alarm_list.h"

#include "core/alarms/catalogue.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

const AlarmEntry& kEntry = alarmEntry("bus.down");
const QStringList kText{QStringLiteral("can0 does not exist")};

// REQ-ALARMS-29 (AlarmList.*): An active alarm comes before one that is over, and a cause before its symptom. Silence
// never hides a lost bus, or two boards with the same id, which are searched for when no drive replies. Each silence is
// reported, also before the re-arm and beside a fault.
TEST(AlarmList, AnAlarmIsNewOnlyOnce)
{
    AlarmList alarms;
    EXPECT_TRUE(alarms.raise(kEntry, Severity::Alarm, kText, {}));
    EXPECT_FALSE(alarms.raise(kEntry, Severity::Alarm, kText, {}));
    EXPECT_EQ(alarms.list().size(), 1U);
}

TEST(AlarmList, AFinishedAlarmStaysUntilSomebodyHasSeenIt)
{
    AlarmList alarms;
    alarms.raise(kEntry, Severity::Alarm, kText, {});
    EXPECT_TRUE(alarms.clear(kEntry));
    EXPECT_FALSE(alarms.clear(kEntry));
    ASSERT_EQ(alarms.list().size(), 1U);
    EXPECT_FALSE(alarms.list().front().active);
    alarms.acknowledgeAll();
    EXPECT_TRUE(alarms.list().empty());
}

TEST(AlarmList, AnAcknowledgedAlarmStaysWhileItsCauseLasts)
{
    AlarmList alarms;
    alarms.raise(kEntry, Severity::Alarm, kText, {});
    alarms.acknowledgeAll();
    ASSERT_EQ(alarms.list().size(), 1U);
    EXPECT_TRUE(alarms.list().front().acknowledged);
    alarms.clear(kEntry);
    EXPECT_TRUE(alarms.list().empty());
}

TEST(AlarmList, ARepeatedCauseMustBeAcknowledgedAgain)
{
    AlarmList alarms;
    alarms.raise(kEntry, Severity::Alarm, kText, {});
    alarms.acknowledgeAll();
    alarms.clear(kEntry);
    EXPECT_TRUE(alarms.raise(kEntry, Severity::Alarm, kText, {}));
    EXPECT_FALSE(alarms.list().front().acknowledged);
}

TEST(AlarmList, WhatGetsWorseOrTurnsIntoSomethingElseIsNew)
{
    AlarmList alarms;
    alarms.raise(kEntry, Severity::Warning, kText, {});
    alarms.acknowledgeAll();
    EXPECT_TRUE(alarms.raise(kEntry, Severity::Alarm, kText, {}));
    EXPECT_FALSE(alarms.list().front().acknowledged);
    alarms.acknowledgeAll();
    EXPECT_TRUE(alarms.raise(kEntry, Severity::Alarm, {QStringLiteral("the adapter is gone")}, {}));
    EXPECT_FALSE(alarms.list().front().acknowledged);
    EXPECT_EQ(alarms.list().size(), 1U);
}

TEST(AlarmList, AChangingNumberMakesNoNewAlarm)
{
    AlarmList alarms;
    const AlarmEntry& entry = alarmEntry("target.outside");
    EXPECT_TRUE(alarms.raise(entry, Severity::Advisory, {QStringLiteral("elevation -5.0°")}, {}));
    EXPECT_FALSE(alarms.raise(entry, Severity::Advisory, {QStringLiteral("elevation -6.0°")}, {}));
    EXPECT_TRUE(alarms.list().front().what.endsWith(QStringLiteral("-6.0°).")));
}

TEST(AlarmList, AlarmsOfOnePlaceTakeEachOthers)
{
    AlarmList alarms;
    const AlarmKey fault = alarmEntry("drive.fault-unnamed").of(Axis::Azimuth);
    const AlarmKey timedOut = alarmEntry("drive.timed-out").of(Axis::Azimuth);
    const QStringList drive{QStringLiteral("azimuth drive")};
    EXPECT_TRUE(alarms.raise(fault, Severity::Alarm, drive, {}));
    EXPECT_TRUE(alarms.raise(timedOut, Severity::Alarm, drive, {})) << "another, so news";
    ASSERT_EQ(alarms.list().size(), 1U);
    EXPECT_EQ(alarms.list().front().name, QStringLiteral("drive.timed-out"));
    EXPECT_EQ(alarms.list().front().about, QStringLiteral("azimuth"));
    EXPECT_FALSE(alarms.active(alarmEntry("drive.timed-out").of(Axis::Elevation)));
    EXPECT_TRUE(alarms.clear(fault)) << "what stands in its place";
}

// Story: when the adapter was unplugged the screen showed "no reply from the elevation drive", the last of three
// alarms.
TEST(AlarmList, WorstFirstThenTheCauseBeforeItsResults)
{
    AlarmList alarms;
    alarms.raise(kEntry.of(QStringLiteral("1")), Severity::Warning, kText, {});
    alarms.raise(kEntry.of(QStringLiteral("2")), Severity::Alarm, kText, {});
    alarms.raise(kEntry.of(QStringLiteral("3")), Severity::Alarm, kText, {});
    const auto ids = [&] {
        std::vector<std::uint64_t> found;
        for (const Alarm& alarm : alarms.list()) {
            found.push_back(alarm.id);
        }
        return found;
    };
    EXPECT_EQ(ids(), (std::vector<std::uint64_t>{2, 3, 1}));
    alarms.clear(kEntry.of(QStringLiteral("2")));
    EXPECT_EQ(ids(), (std::vector<std::uint64_t>{3, 1, 2})) << "what is over is less urgent";
}

// Story: two red alarms that were over hid the amber warning about the hot elevation drive.
TEST(AlarmList, WhatLastsComesBeforeWhatIsOver)
{
    AlarmList alarms;
    alarms.raise(kEntry.of(QStringLiteral("1")), Severity::Alarm, kText, {});
    alarms.raise(kEntry.of(QStringLiteral("2")), Severity::Warning, kText, {});
    alarms.acknowledgeAll();
    alarms.raise(kEntry.of(QStringLiteral("3")), Severity::Alarm, kText, {});
    alarms.clear(kEntry.of(QStringLiteral("1")));
    alarms.clear(kEntry.of(QStringLiteral("3")));
    ASSERT_EQ(alarms.list().size(), 2U);
    EXPECT_EQ(alarms.list().front().severity, Severity::Warning);
}

// Story: "no reply … are the drives powered?" hid the missing adapter, because it was detected first.
TEST(AlarmList, TheCauseComesBeforeASymptomThatWasSeenEarlier)
{
    AlarmList alarms;
    alarms.raise(alarmEntry("drive.answers-again"), Severity::Alarm, {QStringLiteral("azimuth drive")}, {});
    alarms.raise(kEntry, Severity::Alarm, kText, {});
    EXPECT_EQ(alarms.list().front().id, 2U);
    alarms.clear(kEntry);
    EXPECT_EQ(alarms.list().front().id, 1U) << "alone it comes first";
}

std::vector<std::string> namesOf(const AlarmList& alarms)
{
    std::vector<std::string> names;
    for (const Alarm& alarm : alarms.list()) {
        names.push_back(alarm.name.toStdString());
    }
    return names;
}

void raise(AlarmList& alarms, const AlarmKey& key)
{
    QStringList arguments;
    for (int i = 0; i < key.entry->argumentCount(); ++i) {
        arguments << QStringLiteral("x");
    }
    static_cast<void>(alarms.raise(key, key.entry->severity, arguments, {}));
}

// REQ-ALARMS-302 (AlarmCause.*): The root cause is on top, whatever the severity or order: a lost bus before the faults
// of the drives, a disturbed bus before silences, a fault of a drive before its silence. While the bus is lost no
// silence is listed, because the loss explains it.
TEST(AlarmCause, ABusThatIsGoneStandsBeforeFaultsAndSilencesAlsoWhenItWasAcknowledged)
{
    AlarmList alarms;
    raise(alarms, alarmEntry("drive.fault").of(Axis::Elevation));
    raise(alarms, alarmEntry("drive.silent").of(Axis::Azimuth));
    raise(alarms, alarmEntry("bus.down"));
    alarms.acknowledgeAll();
    raise(alarms, alarmEntry("drive.silent").of(Axis::Elevation));
    EXPECT_EQ(namesOf(alarms), (std::vector<std::string>{"bus.down", "drive.fault"}));
    EXPECT_TRUE(alarms.list().front().acknowledged);
}

TEST(AlarmCause, ASilenceThatOutlastsItsBusIsListed)
{
    AlarmList alarms;
    raise(alarms, alarmEntry("drive.silent").of(Axis::Azimuth));
    raise(alarms, alarmEntry("bus.down"));
    EXPECT_EQ(namesOf(alarms), (std::vector<std::string>{"bus.down"}));
    alarms.clear(alarmEntry("bus.down"));
    EXPECT_EQ(namesOf(alarms), (std::vector<std::string>{"drive.silent", "bus.down"}));
}

TEST(AlarmCause, AWarningOfTheBusStandsBeforeTheSilenceThatItExplains)
{
    AlarmList alarms;
    raise(alarms, alarmEntry("drive.silent").of(Axis::Azimuth));
    raise(alarms, alarmEntry("rotctld.not-listening"));
    raise(alarms, alarmEntry("bus.trouble"));
    EXPECT_EQ(namesOf(alarms), (std::vector<std::string>{"bus.trouble", "rotctld.not-listening", "drive.silent"}));
    alarms.clear(alarmEntry("drive.silent").of(Axis::Azimuth));
    alarms.acknowledgeAll();
    EXPECT_EQ(namesOf(alarms), (std::vector<std::string>{"rotctld.not-listening", "bus.trouble"}))
        << "alone it is a warning";
}

TEST(AlarmCause, AFaultStandsBeforeTheSilenceOfItsOwnDrive)
{
    AlarmList alarms;
    raise(alarms, alarmEntry("drive.fault").of(Axis::Azimuth));
    alarms.acknowledgeAll();
    raise(alarms, alarmEntry("drive.silent").of(Axis::Azimuth));
    EXPECT_EQ(namesOf(alarms), (std::vector<std::string>{"drive.fault", "drive.silent"}));
    raise(alarms, alarmEntry("drive.silent").of(Axis::Elevation));
    alarms.clear(alarmEntry("drive.silent").of(Axis::Azimuth));
    EXPECT_EQ(namesOf(alarms).front(), "drive.silent") << "of the other axis, and new";
}

TEST(AlarmCause, WhatIsOverExplainsNothing)
{
    AlarmList alarms;
    raise(alarms, alarmEntry("bus.down"));
    alarms.clear(alarmEntry("bus.down"));
    raise(alarms, alarmEntry("drive.silent").of(Axis::Azimuth));
    EXPECT_EQ(namesOf(alarms), (std::vector<std::string>{"drive.silent", "bus.down"}));
}

}  // namespace
}  // namespace boresight
