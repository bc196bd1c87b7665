// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/trend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace boresight::supervision {
namespace {

// The values arrive at 50 Hz in steps of 0.1, the resolution of the reply.
Trend after(Seconds time, const std::function<double(double)>& value)
{
    Trend trend;
    for (int i = 0; i <= std::lround(time.count() * 50.0); ++i) {
        const double seconds = i / 50.0;
        trend.add(SteadyTime(std::chrono::milliseconds(20 * i)), std::round(10.0 * value(seconds)) / 10.0);
    }
    return trend;
}

// REQ-SUPERVISION-14 (Trend.*): Only values along a line are a trend. Steps and swings of the load are no trend.
TEST(Trend, FindsARampWithinATwentiethOfIt)
{
    const auto line = after(Seconds(61.0), [](double t) { return 42.0 + 6.0 * t / 60.0; }).line();
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->now, 48.1, 0.2);
    EXPECT_NEAR(line->perMinute, 6.0, 0.3);
    EXPECT_NEAR(line->timeTo(75.0)->count(), 4.5 * 60.0, 10.0);
    EXPECT_FALSE(line->timeTo(40.0)) << "it leads away from there";
}

TEST(Trend, WaitsUntilItHasSeenEnough)
{
    const auto ramp = [](double t) { return 30.0 + t / 10.0; };
    EXPECT_FALSE(after(Seconds(39.0), ramp).line());
    EXPECT_TRUE(after(Seconds(43.0), ramp).line());
}

TEST(Trend, OnlyTheLastMinuteCounts)
{
    const auto line =
        after(Seconds(300.0), [](double t) { return t < 200.0 ? 90.0 : 30.0 + (t - 200.0) / 20.0; }).line();
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->perMinute, 3.0, 0.1);
}

TEST(Trend, StepsAndSwingsAreNoTrend)
{
    EXPECT_FALSE(after(Seconds(120.0), [](double) { return 24.0; }).line());
    for (double when = 62.0; when < 118.0; when += 4.0) {
        EXPECT_FALSE(after(Seconds(120.0), [when](double t) { return t < when ? 24.0 : 22.5; }).line()) << when;
    }
    EXPECT_FALSE(after(Seconds(120.0), [](double t) { return t < 80.0 ? 24.0 : t < 100.0 ? 23.0 : 22.0; }).line());
    for (const double period : {5.0, 20.0, 40.0, 60.0}) {  // the mount slews and stands still in turns
        const auto swing = [period](double t) { return std::fmod(t, period) < period / 2.0 ? 24.0 : 22.5; };
        EXPECT_FALSE(after(Seconds(120.0), swing).line()) << period;
    }
}

TEST(Trend, TheWarmingOfABoardIsOne)
{
    const auto board = [](double t) { return 70.0 - 40.0 * std::exp(-t / 180.0); };
    const auto line = after(Seconds(60.0), board).line();
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->now, board(60.0), 0.5);
    EXPECT_NEAR(line->perMinute, 60.0 * (70.0 - board(30.0)) / 180.0, 0.5);
}

TEST(Trend, ForgetsWhatWasBeforeALongGap)
{
    Trend trend = after(Seconds(60.0), [](double t) { return 30.0 + t / 10.0; });
    ASSERT_TRUE(trend.line());
    trend.add(SteadyTime(std::chrono::seconds(75)), 30.0);
    EXPECT_FALSE(trend.line());
}

}  // namespace
}  // namespace boresight::supervision
