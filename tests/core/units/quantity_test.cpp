// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/quantity.h"

#include "core/units/direction_text.h"
#include "core/units/duration_text.h"
#include "core/units/sky.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace boresight {
namespace {

static_assert(sizeof(Angle) == sizeof(double));
static_assert(!std::is_convertible_v<double, Angle>);
static_assert(!std::is_constructible_v<Angle, double>);
static_assert(!std::is_convertible_v<Angle, MotorTurns>);
static_assert(!std::is_convertible_v<SkyPointing, AxisPosition>);
static_assert(!std::is_convertible_v<AngularRate, Angle>);

TEST(Quantity, UnitsAgree)
{
    EXPECT_DOUBLE_EQ(Angle::fromTurns(0.25).degrees(), 90.0);
    EXPECT_DOUBLE_EQ((180_deg).radians(), std::numbers::pi);
    EXPECT_DOUBLE_EQ((90_deg).turns(), 0.25);
    EXPECT_DOUBLE_EQ(MotorTurns::fromTurns(1.5).turns(), 1.5);
}

// Story: a mount parked at north stood at -0.004° and was shown at 360.00°.
// REQ-UNITS-941: After rounding, an azimuth in a text is from 0° up to, but not including, 360°. No angle is "-0.0°".
TEST(DegreesText, NorthIsZeroFromBothSides)
{
    EXPECT_EQ(azimuthText(-0.004_deg, 2), QStringLiteral("0.00°"));
    EXPECT_EQ(azimuthText(-0.01_deg, 2), QStringLiteral("359.99°"));
    EXPECT_EQ(azimuthText(-0.01_deg), QStringLiteral("0.0°"));
    EXPECT_EQ(azimuthText(359.6_deg, 0), QStringLiteral("0°"));
    EXPECT_EQ(azimuthText(360_deg), QStringLiteral("0.0°"));
    EXPECT_EQ(azimuthText(719.97_deg), QStringLiteral("0.0°"));
    EXPECT_EQ(azimuthText(-45_deg), QStringLiteral("315.0°"));
    EXPECT_EQ(degreesText(-0.04_deg), QStringLiteral("0.0°"));
    EXPECT_EQ(directionText({-0.004_deg, -0.004_deg}), QStringLiteral("0.00° 0.00°"));
    EXPECT_EQ(beamText({359.97_deg, -0.04_deg}), QStringLiteral("0.0° / 0.0°"));
    EXPECT_EQ(placeText({-45_deg, 10_deg}), QStringLiteral("-45.00° 10.00°"));
}

// REQ-UNITS-02: An angle divided by a time is a rate, and a rate times a time is an angle.
TEST(Quantity, RateIsAngleDividedByTime)
{
    const AngularRate rate = 10_deg / Seconds(2.0);
    EXPECT_DOUBLE_EQ(rate.degrees(), 5.0);
    EXPECT_DOUBLE_EQ((rate * Seconds(3.0)).degrees(), 15.0);
    EXPECT_DOUBLE_EQ((rate / Seconds(0.5)).degrees(), 10.0);
}

// REQ-UNITS-03: Wrapping is explicit: 370° stays 370° until `wrapped360()` is called.
TEST(Quantity, WrappingIsExplicit)
{
    EXPECT_NEAR((370_deg).wrapped360().degrees(), 10.0, 1e-12);
    EXPECT_NEAR((-10_deg).wrapped360().degrees(), 350.0, 1e-12);
    EXPECT_NEAR((190_deg).wrapped180().degrees(), -170.0, 1e-12);
    EXPECT_NEAR((180_deg).wrapped180().degrees(), -180.0, 1e-12);
    EXPECT_LT(Angle::fromRadians(-1e-20).wrapped360(), 360_deg);
    EXPECT_NEAR((10_deg).nearestTo(365_deg).degrees(), 370.0, 1e-12);
    EXPECT_NEAR((350_deg).nearestTo(5_deg).degrees(), -10.0, 1e-12);
}

// REQ-UNITS-05: A travel range includes its ends.
TEST(Quantity, TravelRangeIncludesItsEnds)
{
    const TravelRange range{.min = -90_deg, .max = 450_deg};
    EXPECT_TRUE(range.contains(450_deg));
    EXPECT_FALSE(range.contains(450.001_deg));
    EXPECT_EQ(range.clamped(-100_deg), -90_deg);
    EXPECT_EQ(range.clamped(500_deg), 450_deg);
    EXPECT_EQ(range.clamped(10_deg), 10_deg);
}

// REQ-UNITS-940: A duration is written in seconds, in minutes and seconds, or in hours and minutes, whichever is short.
TEST(Quantity, ADurationIsWrittenShort)
{
    EXPECT_EQ(durationText(Seconds(99.4)), QStringLiteral("99 s"));
    EXPECT_EQ(durationText(Seconds(100.0)), QStringLiteral("1 min 40 s"));
    EXPECT_EQ(durationText(Seconds(5999.0)), QStringLiteral("99 min 59 s"));
    EXPECT_EQ(durationText(Seconds(6000.0)), QStringLiteral("1 h 40 min"));
    EXPECT_EQ(durationText(Seconds(46866.0)), QStringLiteral("13 h 1 min"));
    EXPECT_EQ(durationText(Seconds(7199.0)), QStringLiteral("2 h 0 min"));
}

}  // namespace
}  // namespace boresight
