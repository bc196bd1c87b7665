// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/axis_trace.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

using namespace boresight::literals;

constexpr SteadyTime kBegin{std::chrono::hours(1)};

SteadyTime at(double seconds)
{
    return kBegin + std::chrono::duration_cast<SteadyTime::duration>(Seconds(seconds));
}

// Turning at 5°/s from 100°, for four seconds.
AxisTrace turning()
{
    AxisTrace trace;
    for (double time = 0.0; time < 4.0; time += 0.02) {
        trace.note(at(time), {.azimuth = 100_deg + 5_deg * time, .elevation = 30_deg}, time < 1.0 ? -2.0 : 0.5);
    }
    return trace;
}

TEST(AxisTrace, TellsWhereTheAxesWereInTheMiddleOfAnAverage)
{
    const auto then = turning().about(at(2.4), Seconds(1.0));
    ASSERT_TRUE(then);
    EXPECT_NEAR(112.0, then->place.azimuth.degrees(), 0.11);
    EXPECT_NEAR(5.0, then->rates.azimuth.degrees(), 1e-6);
    EXPECT_NEAR(30.0, then->place.elevation.degrees(), 1e-9);
    EXPECT_DOUBLE_EQ(0.5, then->current);
    // Story: the current ripple of a slowly turning motor, 9 Nm for 20 ms at 4 Nm on average, was taken for its
    // current. A whole swing of the simulated mount was refused.
    EXPECT_NEAR(1.25, turning().about(at(1.0), Seconds(1.0))->current, 0.05);
}

TEST(AxisTrace, TellsNothingAboutWhatWasNotSeen)
{
    EXPECT_FALSE(AxisTrace().now());
    EXPECT_FALSE(turning().about(at(0.4), Seconds(1.0)));
    EXPECT_FALSE(turning().about(at(3.9), Seconds(1.0)));
    AxisTrace trace = turning();
    trace.note(at(6.0), {.azimuth = 100_deg, .elevation = 30_deg}, 0.0);  // two seconds without an observation
    EXPECT_FALSE(trace.about(at(3.0), Seconds(0.5)));
    EXPECT_FALSE(trace.now());
}

TEST(AxisTrace, NowIsTheNewestPlace)
{
    const auto now = turning().now();
    ASSERT_TRUE(now);
    EXPECT_NEAR(119.9, now->place.azimuth.degrees(), 1e-6);
    EXPECT_NEAR(5.0, now->rates.azimuth.degrees(), 1e-6);
}

}  // namespace
}  // namespace boresight
