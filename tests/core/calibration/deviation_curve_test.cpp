// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/deviation_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace boresight::calibration {
namespace {

DeviationCurve strong(AzimuthSense sense = AzimuthSense::Clockwise)
{
    return {.sense = sense,
            .constant = 1_deg,
            .a1 = 8_deg,
            .b1 = -12_deg,
            .a2 = 3_deg,
            .b2 = 5_deg,
            .scatter = {},
            .unreliable = {{.from = 200_deg, .to = 230_deg, .residual = 15_deg}}};
}

// REQ-CALIBRATION-09 (DeviationCurve.*): Later readings are corrected by the exact inverse of the curve. The curve is a
// function of the true heading. Declination is added to north, whichever way the sensor counts.
TEST(DeviationCurve, IsWhatTheFormulaSays)
{
    const DeviationCurve curve = strong();
    // At 0° only the cosines count, at 90° a1 and -b2, at 45° both first terms by 1/√2, and a2.
    EXPECT_NEAR(curve.deviation(0_deg).degrees(), -12.0 + 5.0, 1e-12);
    EXPECT_NEAR(curve.deviation(90_deg).degrees(), 8.0 - 5.0, 1e-12);
    EXPECT_NEAR(curve.deviation(45_deg).degrees(), (8.0 - 12.0) * 0.70710678118654752 + 3.0, 1e-12);
    EXPECT_NEAR(curve.reading(0_deg).angle().degrees(), 360.0 + 1.0 - 7.0, 1e-9);
}

TEST(DeviationCurve, CorrectsExactly)
{
    for (const AzimuthSense sense : {AzimuthSense::Clockwise, AzimuthSense::CounterClockwise}) {
        const DeviationCurve curve = strong(sense);
        ASSERT_TRUE(curve.isInvertible());
        for (int tenth = 0; tenth < 3600; ++tenth) {
            const Angle heading = Angle::fromDegrees(tenth / 10.0);
            const Angle back = curve.corrected(curve.reading(heading));
            ASSERT_NEAR((back - heading).wrapped180().degrees(), 0.0, 1e-11) << heading.degrees();
        }
    }
}

TEST(DeviationCurve, CorrectsExactlyUpToTheSteepestThatIsInvertible)
{
    DeviationCurve curve;
    curve.a1 = 51_deg;
    ASSERT_TRUE(curve.isInvertible());
    for (int heading = 0; heading < 360; ++heading) {
        const Angle back = curve.corrected(curve.reading(Angle::fromDegrees(heading)));
        ASSERT_NEAR((back - Angle::fromDegrees(heading)).wrapped180().degrees(), 0.0, 1e-9) << heading;
    }
    curve.a1 = 58_deg;  // beyond 1 rad the reading of the sensor turns back while the mount turns on
    EXPECT_FALSE(curve.isInvertible());
}

// The two harmonics are steepest at different headings, so their sum is less steep than the sum of their slopes.
TEST(DeviationCurve, IsInvertibleWhereverItIsNowhereTooSteep)
{
    DeviationCurve curve;
    curve.a1 = 30_deg;  // falls steepest at 180°
    curve.a2 = 14_deg;  // rises steepest at 180°, falls steepest at 90°
    EXPECT_FALSE((curve.firstAmplitude() + curve.secondAmplitude() * 2.0).radians() < 0.9);
    ASSERT_TRUE(curve.isInvertible());
    for (int heading = 0; heading < 360; ++heading) {
        const Angle back = curve.corrected(curve.reading(Angle::fromDegrees(heading)));
        ASSERT_NEAR((back - Angle::fromDegrees(heading)).wrapped180().degrees(), 0.0, 1e-9) << heading;
    }
    curve.a2 = -14_deg;  // falls steepest at 180°, too
    EXPECT_FALSE(curve.isInvertible());
}

// Iron that is fixed to the box, in any direction: a curve found at 20° elevation is different at 75°.
TEST(DeviationCurve, TheSigmaAwayFromItsElevationIsHonest)
{
    std::mt19937_64 random(3);
    std::normal_distribution<double> strength(0.0, 5.0);  // degrees of deflection
    std::uniform_real_distribution<double> anywhere(0.0, 360.0);
    constexpr int kBoxes = 1000;
    int inside = 0;
    int insideHalf = 0;
    for (int i = 0; i < kBoxes; ++i) {
        const double forward = strength(random);
        const double right = strength(random);
        const double up = strength(random);
        const auto curveAt = [&](Angle elevation) {
            const double level = forward * std::cos(elevation.radians()) - up * std::sin(elevation.radians());
            return DeviationCurve{
                .a1 = Angle::fromDegrees(level), .b1 = Angle::fromDegrees(right), .elevation = elevation};
        };
        const DeviationCurve swung = curveAt(20_deg);
        const Angle heading = Angle::fromDegrees(anywhere(random));
        const Angle off = abs(curveAt(75_deg).deviation(heading) - swung.deviation(heading));
        inside += off < swung.sigmaAt(75_deg) * 2.0 ? 1 : 0;
        insideHalf += off < swung.sigmaAt(75_deg) * 0.5 ? 1 : 0;
    }
    EXPECT_GE(inside, kBoxes * 93 / 100);
    EXPECT_LE(insideHalf, kBoxes * 65 / 100);
    EXPECT_EQ(DeviationCurve{.a1 = 8_deg}.sigmaAt(60_deg), Angle{}) << "of a curve that does not tell";
}

TEST(DeviationCurve, KnowsWhereItIsNotToBeBelieved)
{
    const DeviationCurve curve = strong();
    EXPECT_TRUE(curve.isReliable(199_deg));
    EXPECT_FALSE(curve.isReliable(215_deg));
    EXPECT_TRUE(curve.isReliable(231_deg));
    EXPECT_TRUE(curve.isReliable(190_deg, 199_deg));
    EXPECT_FALSE(curve.isReliable(190_deg, 201_deg));
    EXPECT_FALSE(curve.isReliable(190_deg, 240_deg));
    EXPECT_FALSE(curve.isReliable(589_deg, 600_deg)) << "a turn further";
    EXPECT_TRUE(curve.isReliable(231_deg, 550_deg));
    const UnreliableSector throughNorth{.from = 350_deg, .to = 10_deg, .residual = {}};
    EXPECT_TRUE(throughNorth.contains(0_deg));
    EXPECT_TRUE(throughNorth.contains(355_deg));
    EXPECT_FALSE(throughNorth.contains(180_deg));
    const UnreliableSector everywhere{.from = 0_deg, .to = 360_deg, .residual = {}};
    EXPECT_TRUE(everywhere.contains(180_deg));
    DeviationCurve hopeless;
    hopeless.unreliable = {everywhere};
    EXPECT_FALSE(hopeless.withNorthMoved(12.3_deg).isReliable(200_deg));
}

TEST(DeviationCurve, SaysTheSameWhenNorthIsFoundElsewhere)
{
    const DeviationCurve before = strong();
    const DeviationCurve after = before.withNorthMoved(2.5_deg);
    for (int heading = 0; heading < 360; heading += 7) {
        const Angle old = Angle::fromDegrees(heading);
        const Angle moved = old + 2.5_deg;
        EXPECT_NEAR((after.reading(moved).angle() - before.reading(old).angle()).wrapped180().degrees(), 0.0, 1e-9);
        EXPECT_NEAR((after.corrected(before.reading(old)) - moved).wrapped180().degrees(), 0.0, 1e-9);
        EXPECT_EQ(after.isReliable(moved), before.isReliable(old)) << heading;
    }
}

}  // namespace
}  // namespace boresight::calibration
