// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/alarm_board.h"

#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

const QString kBus = QStringLiteral("bus");
const QString kOver = QStringLiteral("the alarm is over");

class AlarmBoardTest : public testing::Test
{
protected:
    void raise(const QString& cause, const QString& what) { board.raise(cause, Severity::Alarm, {.what = what}); }
    [[nodiscard]] qsizetype lines(const QString& source, const QString& text) const
    {
        return std::ranges::count_if(log.since(0, EventLog::kCapacity),
                                     [&](const auto& line) { return line.source == source && line.text == text; });
    }

    fakes::ManualClock clock;
    EventLog log{clock};
    AlarmBoard board{log, clock};
};

// A cable pulled and plugged in again within a second: bus, drives, sensor.
TEST_F(AlarmBoardTest, ManyAlarmsAtOnceAllHaveTheirLines)
{
    for (int i = 0; i < 12; ++i) {
        raise(QString::number(i), QStringLiteral("Lost."));
    }
    for (int i = 0; i < 12; ++i) {
        board.clear(QString::number(i));
        EXPECT_EQ(lines(QString::number(i), QStringLiteral("Lost.")), 1) << i;
        EXPECT_EQ(lines(QString::number(i), kOver), 1) << i;
    }
}

TEST_F(AlarmBoardTest, ALineDoesNotNameItsCauseTwice)
{
    board.raise(kBus, Severity::Alarm, {.what = QStringLiteral("bus fault 3"), .brief = QStringLiteral("fault 3")});
    EXPECT_EQ(lines(kBus, QStringLiteral("Fault 3.")), 1);
    EXPECT_EQ(board.list().front().what, QStringLiteral("Bus fault 3."));
}

TEST_F(AlarmBoardTest, WhatWasToldIsAlsoToldToBeOver)
{
    for (int i = 0; i < 100; ++i) {  // another each time: each is news
        raise(kBus, QStringLiteral("Trouble %1.").arg(i));
    }
    EXPECT_LT(log.lastNumber(), 10U);
    board.clear(kBus);
    const auto all = log.since(0, EventLog::kCapacity);
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(all.back().text, kOver);
}

TEST_F(AlarmBoardTest, ACableThatFlickersDoesNotFloodTheLog)
{
    for (int i = 0; i < 1000; ++i) {
        raise(kBus, QStringLiteral("Lost."));
        board.clear(kBus);
    }
    EXPECT_LT(log.lastNumber(), 10U);
    const qsizetype told = lines(kBus, QStringLiteral("Lost."));
    EXPECT_GT(told, 0);
    EXPECT_EQ(lines(kBus, kOver), told);

    clock.advance(Seconds(1.0));
    raise(kBus, QStringLiteral("Lost."));
    EXPECT_EQ(log.since(0, EventLog::kCapacity).back().text, QStringLiteral("Lost."));
    EXPECT_EQ(lines(QStringLiteral("log"), QStringLiteral("%1 similar lines left out").arg(1000 - told)), 1);
}

// Story: a loose plug, lost at last. The log ended with "the alarm is over" while the alarm stood.
TEST_F(AlarmBoardTest, WhatStandsAfterAFlickerIsToldInTheEnd)
{
    for (int i = 0; i < 10; ++i) {
        raise(kBus, QStringLiteral("Lost."));
        board.clear(kBus);
    }
    raise(kBus, QStringLiteral("Lost."));
    ASSERT_EQ(log.since(0, EventLog::kCapacity).back().text, kOver);
    clock.advance(Seconds(0.9));
    board.tick();
    ASSERT_EQ(log.since(0, EventLog::kCapacity).back().text, kOver);
    clock.advance(Seconds(0.1));
    board.tick();
    EXPECT_EQ(log.since(0, EventLog::kCapacity).back().text, QStringLiteral("Lost."));
    board.tick();
    EXPECT_EQ(lines(kBus, QStringLiteral("Lost.")), 3) << "once";
    board.clear(kBus);
    EXPECT_EQ(log.since(0, EventLog::kCapacity).back().text, kOver);
}

// What was over before the second was is not told any more.
TEST_F(AlarmBoardTest, WhatIsOverIsNotToldToBegin)
{
    for (int i = 0; i < 10; ++i) {
        raise(kBus, QStringLiteral("Lost."));
        board.clear(kBus);
    }
    const auto before = log.lastNumber();
    clock.advance(Seconds(2.0));
    board.tick();
    EXPECT_EQ(log.lastNumber(), before);
}

}  // namespace
}  // namespace boresight
