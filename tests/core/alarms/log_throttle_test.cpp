// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/log_throttle.h"

#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

const QString kSource = QStringLiteral("client");

TEST(LogThrottle, TheSameLineIsWrittenOnceInTenSeconds)
{
    fakes::ManualClock clock;
    EventLog log(clock);
    LogThrottle throttle(log, clock, 10);
    for (int i = 0; i < 5; ++i) {
        throttle.add(Severity::Warning, kSource, QStringLiteral("refused"));
        clock.advance(Seconds(1.0));
    }
    EXPECT_EQ(log.lastNumber(), 1U);
    clock.advance(Seconds(10.0));
    throttle.add(Severity::Warning, kSource, QStringLiteral("refused"));
    const auto lines = log.since(0, 10);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[1].text, QStringLiteral("4 similar lines left out"));
    EXPECT_EQ(lines[2].text, QStringLiteral("refused"));
}

TEST(LogThrottle, AFloodOfDifferentLinesIsCutToTenASecond)
{
    fakes::ManualClock clock;
    EventLog log(clock);
    LogThrottle throttle(log, clock, 10);
    for (int i = 0; i < 1000; ++i) {
        throttle.add(Severity::Advisory, kSource, QString::number(i));
    }
    EXPECT_EQ(log.lastNumber(), 10U);
}

TEST(EventLog, KeepsTheNewestAndGivesWhatIsNew)
{
    fakes::ManualClock clock;
    EventLog log(clock);
    for (std::size_t i = 0; i < EventLog::kCapacity + 5; ++i) {
        log.add(Severity::Advisory, kSource, QString::number(i));
    }
    const auto newest = log.since(log.lastNumber() - 2, 10);
    ASSERT_EQ(newest.size(), 2U);
    EXPECT_EQ(newest.back().number, log.lastNumber());
    EXPECT_EQ(log.since(0, 100000).size(), EventLog::kCapacity);
    EXPECT_EQ(log.since(0, 3).back().number, log.lastNumber());
}

}  // namespace
}  // namespace boresight
