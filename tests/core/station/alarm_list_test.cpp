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

TEST(AlarmList, WorstFirstThenNewest)
{
    AlarmList alarms;
    alarms.raise(QStringLiteral("1"), Severity::Warning, kText, {});
    alarms.raise(QStringLiteral("2"), Severity::Alarm, kText, {});
    alarms.raise(QStringLiteral("3"), Severity::Alarm, kText, {});
    const std::vector<Alarm> list = alarms.list();
    ASSERT_EQ(list.size(), 3U);
    EXPECT_EQ(list[0].id, 3U);
    EXPECT_EQ(list[1].id, 2U);
    EXPECT_EQ(list[2].severity, Severity::Warning);
}

}  // namespace
}  // namespace boresight
