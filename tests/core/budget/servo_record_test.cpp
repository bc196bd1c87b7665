// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/budget/servo_record.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boresight::budget {
namespace {

SteadyTime after(double seconds)
{
    return SteadyTime{} + std::chrono::duration_cast<SteadyTime::duration>(Seconds(seconds));
}

// REQ-BUDGET-01: The servo error is measured: its rms and its peak over the last 10 s, and the newest value.
TEST(ServoRecord, IsTheRmsOfTheLastTenSeconds)
{
    ServoRecord record;
    EXPECT_FALSE(record.summary(after(0.0)));
    for (int i = 0; i < 500; ++i) {
        record.add(after(0.02 * i), i % 2 == 0 ? 0.03_deg : 0.05_deg);
    }
    const auto whole = record.summary(after(9.98));
    ASSERT_TRUE(whole);
    EXPECT_NEAR(whole->rms.degrees(), std::sqrt((0.03 * 0.03 + 0.05 * 0.05) / 2.0), 1e-12);
    EXPECT_EQ(whole->peak, 0.05_deg);
    EXPECT_EQ(whole->now, 0.05_deg);
    for (int i = 500; i < 1100; ++i) {
        record.add(after(0.02 * i), 0.01_deg);
    }
    const auto later = record.summary(after(21.98));
    ASSERT_TRUE(later);
    EXPECT_NEAR(later->rms.degrees(), 0.01, 1e-12);
    EXPECT_EQ(later->peak, 0.01_deg);
}

// REQ-BUDGET-02: After 2 s without a measurement the servo error is unknown.
TEST(ServoRecord, AnOldMeasurementIsNotLive)
{
    ServoRecord record;
    record.add(after(0.0), 0.04_deg);
    EXPECT_TRUE(record.summary(after(2.0)));
    EXPECT_FALSE(record.summary(after(2.1)));
}

}  // namespace
}  // namespace boresight::budget
