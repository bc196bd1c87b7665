// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/cable_forecast.h"

#include <gtest/gtest.h>

namespace boresight::tracking {
namespace {

constexpr TravelRange kRange{-90_deg, 450_deg};

MovingTarget moving(Angle azimuth, Angle elevation, AngularRate azimuthRate, AngularRate elevationRate = 0_deg_s)
{
    return {.position = {azimuth, elevation}, .rates = {azimuthRate, elevationRate}, .streaming = true};
}

// Along the horizon a great circle has a constant azimuth rate.
// REQ-CONTROL-31 (CableForecast.*): The azimuth range may end before the path that is tracked. This is reported 60 s or
// 30° ahead, whichever is earlier, with the UTC of the end and what will happen there (unwrapping by 360°, or waiting
// at the end). The report stays true while it is shown. It is renewed when the time moves by 10 s, or by a fifth of the
// remaining time.
TEST(CableForecast, OnTheHorizonItIsTheWayDividedByTheRate)
{
    const auto forecast = forecastCableEnd(moving(410_deg, 0_deg, 1_deg_s), kRange);
    ASSERT_TRUE(forecast.has_value());
    EXPECT_NEAR(forecast->in.count(), 40.0, 1e-6);
    EXPECT_EQ(forecast->end, 450_deg);
    EXPECT_NEAR(forecast->left.degrees(), 40.0, 1e-9);
    const auto other = forecastCableEnd(moving(-60_deg, 0_deg, -0.5_deg_s), kRange);
    ASSERT_TRUE(other.has_value());
    EXPECT_NEAR(other->in.count(), 60.0, 1e-6);
    EXPECT_EQ(other->end, -90_deg);
}

// Culminating at 60° at an azimuth of 400°, moving across the sky at 0.5°/s. After 30° (60 s) on the great circle the
// azimuth has turned by atan(tan 30° / cos 60°) = 49.107°. The end at 449.107° is there.
TEST(CableForecast, FollowsTheGreatCircle)
{
    const TravelRange range{-90_deg, Angle::fromDegrees(449.10660535)};
    const auto forecast = forecastCableEnd(moving(400_deg, 60_deg, 1_deg_s), range);
    ASSERT_TRUE(forecast.has_value());
    EXPECT_NEAR(forecast->in.count(), 60.0, 0.05);
}

// At 86° the azimuth turns at 10°/s for a few seconds only: the pass ends 92° farther.
TEST(CableForecast, AFastAzimuthNearTheZenithIsNoFastAzimuthForAMinute)
{
    EXPECT_FALSE(forecastCableEnd(moving(350_deg, 86_deg, 10_deg_s), kRange).has_value());
    EXPECT_TRUE(forecastCableEnd(moving(365_deg, 86_deg, 10_deg_s), kRange).has_value());
}

TEST(CableForecast, ATargetThatSetsBeforeOrStandsIsNotTold)
{
    EXPECT_FALSE(forecastCableEnd(moving(400_deg, 10_deg, 0.1_deg_s, -1_deg_s), kRange).has_value());
    EXPECT_FALSE(forecastCableEnd(moving(449_deg, 10_deg, 0.0005_deg_s), kRange).has_value());
    EXPECT_FALSE(forecastCableEnd(moving(451_deg, 10_deg, 1_deg_s), kRange).has_value()) << "it is there already";
}

// REQ-CONTROL-31c: The operator sees before the choice how long each choice loses the target: unwrapping, and holding
// at the end. If the path of the target is not known, the second time is an estimate by its present azimuth rate, and
// the text names this condition.
TEST(TimeBeyond, CountsWhatIsPastTheEndAndNothingElse)
{
    const std::vector<PathMoment> path{{.in = Seconds(0.0), .azimuth = 430_deg},
                                       {.in = Seconds(10.0), .azimuth = 440_deg},
                                       {.in = Seconds(30.0), .azimuth = 460_deg},
                                       {.in = Seconds(40.0), .azimuth = 460_deg},
                                       {.in = Seconds(60.0), .azimuth = 440_deg}};
    EXPECT_NEAR(timeBeyond(path, kRange).count(), 10.0 + 10.0 + 10.0, 1e-9);
    EXPECT_NEAR(timeBeyond(path, {-90_deg, 470_deg}).count(), 0.0, 1e-9);
    EXPECT_NEAR(timeBeyond(path, {-90_deg, 400_deg}).count(), 60.0, 1e-9);
    EXPECT_EQ(timeBeyond({}, kRange), Seconds(0.0));
}

TEST(TimeBeyond, WhatTheLimitsHideIsNotLostByTheCable)
{
    const std::vector<PathMoment> path{{.in = Seconds(0.0), .azimuth = 455_deg},
                                       {.in = Seconds(10.0), .azimuth = 456_deg},
                                       {.in = Seconds(20.0), .azimuth = 457_deg, .isReachable = false},
                                       {.in = Seconds(30.0), .azimuth = 458_deg}};
    EXPECT_NEAR(timeBeyond(path, kRange).count(), 10.0, 1e-9);
}

TEST(CableForecast, AStarIsToldHoursAhead)
{
    const auto forecast = forecastCableEnd(moving(420_deg, 30_deg, 0.004_deg_s), kRange);
    ASSERT_TRUE(forecast.has_value());
    EXPECT_GT(forecast->in, Seconds(3600.0));
}

}  // namespace
}  // namespace boresight::tracking
