// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/alarm_list.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

const QString kCause = QStringLiteral("bus");
const AlarmText kText{.what = QStringLiteral("w"), .action = QStringLiteral("a"), .remedy = QStringLiteral("r")};

// REQ-ALARMS-29 (AlarmList.*): A lasting alarm stands before one that is over, and a cause before its symptom. Silence
// never hides a bus that is gone, or two boards with one id, which are looked for where nobody answers. A silence is
// reported each time, also before the re-arm and beside a fault.
TEST(AlarmList, AnAlarmIsNewOnlyOnce)
{
    AlarmList alarms;
    EXPECT_TRUE(alarms.raise(kCause, Severity::Alarm, kText, {}));
    EXPECT_FALSE(alarms.raise(kCause, Severity::Alarm, kText, {}));
    EXPECT_EQ(alarms.list().size(), 1U);
}

TEST(AlarmList, AFinishedAlarmStaysUntilSomebodyHasSeenIt)
{
    AlarmList alarms;
    alarms.raise(kCause, Severity::Alarm, kText, {});
    EXPECT_TRUE(alarms.clear(kCause));
    EXPECT_FALSE(alarms.clear(kCause));
    ASSERT_EQ(alarms.list().size(), 1U);
    EXPECT_FALSE(alarms.list().front().active);
    alarms.acknowledgeAll();
    EXPECT_TRUE(alarms.list().empty());
}

TEST(AlarmList, AnAcknowledgedAlarmStaysWhileItsCauseLasts)
{
    AlarmList alarms;
    alarms.raise(kCause, Severity::Alarm, kText, {});
    alarms.acknowledgeAll();
    ASSERT_EQ(alarms.list().size(), 1U);
    EXPECT_TRUE(alarms.list().front().acknowledged);
    alarms.clear(kCause);
    EXPECT_TRUE(alarms.list().empty());
}

TEST(AlarmList, ARepeatedCauseMustBeAcknowledgedAgain)
{
    AlarmList alarms;
    alarms.raise(kCause, Severity::Alarm, kText, {});
    alarms.acknowledgeAll();
    alarms.clear(kCause);
    EXPECT_TRUE(alarms.raise(kCause, Severity::Alarm, kText, {}));
    EXPECT_FALSE(alarms.list().front().acknowledged);
}

TEST(AlarmList, WhatGetsWorseOrTurnsIntoSomethingElseIsNew)
{
    AlarmList alarms;
    alarms.raise(kCause, Severity::Warning, kText, {});
    alarms.acknowledgeAll();
    EXPECT_TRUE(alarms.raise(kCause, Severity::Alarm, kText, {}));
    EXPECT_FALSE(alarms.list().front().acknowledged);
    alarms.acknowledgeAll();
    AlarmText other = kText;
    other.what = QStringLiteral("the adapter is gone");
    EXPECT_TRUE(alarms.raise(kCause, Severity::Alarm, other, {}));
    EXPECT_FALSE(alarms.list().front().acknowledged);
    EXPECT_EQ(alarms.list().size(), 1U);
}

// Story: with the adapter pulled the screen showed "no reply from the elevation drive", the last of three alarms.
TEST(AlarmList, WorstFirstThenTheCauseBeforeItsResults)
{
    AlarmList alarms;
    alarms.raise(QStringLiteral("1"), Severity::Warning, kText, {});
    alarms.raise(QStringLiteral("2"), Severity::Alarm, kText, {});
    alarms.raise(QStringLiteral("3"), Severity::Alarm, kText, {});
    const auto ids = [&] {
        std::vector<std::uint64_t> found;
        for (const Alarm& alarm : alarms.list()) {
            found.push_back(alarm.id);
        }
        return found;
    };
    EXPECT_EQ(ids(), (std::vector<std::uint64_t>{2, 3, 1}));
    alarms.clear(QStringLiteral("2"));
    EXPECT_EQ(ids(), (std::vector<std::uint64_t>{3, 1, 2})) << "what is over is less urgent";
}

// Story: two red alarms that were over stood in the line while the elevation drive was getting hot, in amber.
TEST(AlarmList, WhatLastsComesBeforeWhatIsOver)
{
    AlarmList alarms;
    alarms.raise(QStringLiteral("1"), Severity::Alarm, kText, {});
    alarms.raise(QStringLiteral("2"), Severity::Warning, kText, {});
    alarms.acknowledgeAll();
    alarms.raise(QStringLiteral("3"), Severity::Alarm, kText, {});
    alarms.clear(QStringLiteral("1"));
    alarms.clear(QStringLiteral("3"));
    ASSERT_EQ(alarms.list().size(), 2U);
    EXPECT_EQ(alarms.list().front().severity, Severity::Warning);
}

// Story: "no reply … are the drives powered?" hid that the adapter was gone, because it was noticed first.
TEST(AlarmList, TheCauseComesBeforeASymptomThatWasSeenEarlier)
{
    AlarmList alarms;
    AlarmText silence = kText;
    silence.symptom = true;
    alarms.raise(QStringLiteral("silence"), Severity::Alarm, silence, {});
    alarms.raise(kCause, Severity::Alarm, kText, {});
    EXPECT_EQ(alarms.list().front().id, 2U);
    alarms.clear(kCause);
    EXPECT_EQ(alarms.list().front().id, 1U) << "alone it comes first";
}

}  // namespace
}  // namespace boresight
