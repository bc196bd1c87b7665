// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/alarm_list.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

const QString kCause = QStringLiteral("bus");
const AlarmText kText{.what = QStringLiteral("w"), .action = QStringLiteral("a"), .remedy = QStringLiteral("r")};

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
    EXPECT_EQ(ids(), (std::vector<std::uint64_t>{3, 2, 1})) << "what is over is less urgent";
}

}  // namespace
}  // namespace boresight
