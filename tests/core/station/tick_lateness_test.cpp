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

TEST(TickLateness, ATickThatComesEarlyIsNotLate)
{
    TickLateness lateness(Seconds(0.02));
    lateness.tick(SteadyTime{});
    lateness.tick(SteadyTime{} + std::chrono::milliseconds(10));
    EXPECT_LE(lateness.percentile(1.0).count(), 0.0001);
}

}  // namespace
}  // namespace boresight
