// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/tick_lateness.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

TEST(TickLateness, PercentilesOfKnownDelays)
{
    TickLateness lateness(Seconds(0.02));
    SteadyTime now{};
    lateness.tick(now);
    for (int i = 0; i < 100; ++i) {
        now += std::chrono::milliseconds(i == 50 ? 25 : 20);
        lateness.tick(now);
    }
    EXPECT_EQ(lateness.count(), 100U);
    EXPECT_LE(lateness.percentile(0.5).count(), 0.0001);
    EXPECT_NEAR(lateness.percentile(0.999).count(), 0.005, 0.00011);
}

// Story: after a stall of 12 s the longest lateness was reported as 100 ms.
TEST(TickLateness, LongStallsAreShownAsLongAsTheyWere)
{
    TickLateness lateness(Seconds(0.02));
    SteadyTime now{};
    lateness.tick(now);
    for (const int gap : {20, 20, 20, 20, 20, 20, 20, 320, 1520, 12'365}) {
        now += std::chrono::milliseconds(gap);
        lateness.tick(now);
    }
    EXPECT_NEAR(lateness.percentile(0.7).count(), 0.3, 0.011);
    EXPECT_NEAR(lateness.percentile(0.8).count(), 1.5, 0.011);
    EXPECT_DOUBLE_EQ(lateness.percentile(1.0).count(), 12.345);
}

TEST(TickLateness, ATickThatComesEarlyIsNotLate)
{
    TickLateness lateness(Seconds(0.02));
    lateness.tick(SteadyTime{});
    lateness.tick(SteadyTime{} + std::chrono::milliseconds(10));
    EXPECT_LE(lateness.percentile(1.0).count(), 0.0001);
}

}  // namespace
}  // namespace boresight
