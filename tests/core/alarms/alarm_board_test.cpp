// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/alarm_board.h"

#include "core/alarms/catalogue.h"
#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

const AlarmEntry& kBus = alarmEntry("bus.down");
const QString kBusSource = QStringLiteral("bus");
const QString kOver = QStringLiteral("Cleared: ");

QString wholeLine(const AlarmEntry& entry)
{
    const AlarmText text = textOf(entry, {QStringLiteral("Lost.")});
    return QStringList({text.brief, text.action, text.remedy}).join(QLatin1Char(' '));
}

const QString kLost = wholeLine(kBus);

class AlarmBoardTest : public testing::Test
{
protected:
    void raise(const AlarmKey& key, const QString& what) { board.raise(key, {what}); }
    [[nodiscard]] qsizetype lines(const QString& source, const QString& text) const
    {
        return std::ranges::count_if(log.since(0, EventLog::kCapacity), [&](const auto& line) {
            return line.source == source && (text == kOver ? line.text.startsWith(kOver) : line.text == text);
        });
    }
    [[nodiscard]] QString lastLine() const { return log.since(0, EventLog::kCapacity).back().text; }

    fakes::ManualClock clock;
    EventLog log{clock};
    AlarmBoard board{log, clock};
};

// A cable is unplugged and plugged in again within a second: alarms for bus, drives and sensor.
TEST_F(AlarmBoardTest, ManyAlarmsAtOnceAllHaveTheirLines)
{
    const AlarmEntry& entry = alarmEntry("axis.stalled");
    for (int i = 0; i < 12; ++i) {
        raise(entry.of(QString::number(i)), QStringLiteral("Lost."));
    }
    for (int i = 0; i < 12; ++i) {
        board.clear(entry.of(QString::number(i)));
        EXPECT_EQ(lines(QString::number(i), wholeLine(entry)), 1) << i;
        EXPECT_EQ(lines(QString::number(i), kOver), 1) << i;
    }
}

TEST_F(AlarmBoardTest, ALineDoesNotNameItsSourceTwice)
{
    board.raise(alarmEntry("drive.fault-unnamed").of(Axis::Azimuth), {QStringLiteral("azimuth drive")});
    const LogEntry line = log.since(0, EventLog::kCapacity).back();
    EXPECT_EQ(line.source, QStringLiteral("azimuth drive"));
    EXPECT_EQ(line.alarm.name, QStringLiteral("drive.fault-unnamed"));
    EXPECT_TRUE(line.text.startsWith(QStringLiteral("In fault without a fault code. The drive switched")))
        << line.text.toStdString();
    EXPECT_TRUE(plainLine(line).startsWith(QStringLiteral("azimuth drive [drive.fault-unnamed]: In fault")));
    EXPECT_EQ(board.list().front().what, QStringLiteral("The azimuth drive is in fault without a fault code."));
}

TEST_F(AlarmBoardTest, WhatWasToldIsAlsoToldToBeOver)
{
    for (int i = 0; i < 100; ++i) {  // a different text each time, so each counts as new
        raise(kBus, QStringLiteral("Trouble %1.").arg(i));
    }
    EXPECT_LT(log.lastNumber(), 10U);
    board.clear(kBus);
    EXPECT_EQ(lastLine(), kOver + textOf(kBus, {QStringLiteral("Trouble 99.")}).brief);
}

// Story: the log had the line "azimuth: Cleared." It did not show which of the alarms of the azimuth had ended.
TEST_F(AlarmBoardTest, TheEndNamesTheAlarm)
{
    board.raise(alarmEntry("cable.turns-back").of(Axis::Azimuth),
                {QStringLiteral("450.0°"), QStringLiteral("17:06:10Z"), QStringLiteral("37 s")});
    board.clear(alarmEntry("cable.turns-back").of(Axis::Azimuth));
    EXPECT_EQ(lastLine(), QStringLiteral("Cleared: Reaches its cable end (450.0°) at 17:06:10Z."));
}

TEST_F(AlarmBoardTest, ACableThatFlickersDoesNotFloodTheLog)
{
    for (int i = 0; i < 1000; ++i) {
        raise(kBus, QStringLiteral("Lost."));
        board.clear(kBus);
    }
    EXPECT_LT(log.lastNumber(), 10U);
    const qsizetype told = lines(kBusSource, kLost);
    EXPECT_GT(told, 0);
    EXPECT_EQ(lines(kBusSource, kOver), told);

    clock.advance(Seconds(1.0));
    raise(kBus, QStringLiteral("Lost."));
    EXPECT_EQ(log.since(0, EventLog::kCapacity).back().text, kLost);
    EXPECT_EQ(lines(QStringLiteral("log"), QStringLiteral("%1 similar lines left out").arg(1000 - told)), 1);
}

// Story: a loose plug failed for good. The log ended with "the alarm is over" although the alarm was active.
TEST_F(AlarmBoardTest, WhatStandsAfterAFlickerIsToldInTheEnd)
{
    for (int i = 0; i < 10; ++i) {
        raise(kBus, QStringLiteral("Lost."));
        board.clear(kBus);
    }
    raise(kBus, QStringLiteral("Lost."));
    ASSERT_TRUE(lastLine().startsWith(kOver));
    clock.advance(Seconds(0.9));
    board.tick();
    ASSERT_TRUE(lastLine().startsWith(kOver));
    clock.advance(Seconds(0.1));
    board.tick();
    EXPECT_EQ(log.since(0, EventLog::kCapacity).back().text, kLost);
    board.tick();
    EXPECT_EQ(lines(kBusSource, kLost), 3) << "once";
    board.clear(kBus);
    EXPECT_TRUE(lastLine().startsWith(kOver));
}

// An alarm that is over before the end of the second is not reported as begun.
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
