// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/deviation_curve.h"

#include <gtest/gtest.h>

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

TEST(DeviationCurve, IsWhatTheFormulaSays)
{
    const DeviationCurve curve = strong();
    // At 0° only the cosines count, at 90° a1 and -b2, at 45° both of the first by 1/√2 and a2.
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
    curve.a1 = 58_deg;  // beyond 1 rad the sensor turns back while the mount goes on
    EXPECT_FALSE(curve.isInvertible());
}

TEST(DeviationCurve, KnowsWhereItIsNotToBeBelieved)
{
    const DeviationCurve curve = strong();
    EXPECT_TRUE(curve.isReliable(199_deg));
    EXPECT_FALSE(curve.isReliable(215_deg));
    EXPECT_TRUE(curve.isReliable(231_deg));
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
