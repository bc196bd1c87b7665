// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/correction.h"

#include <gtest/gtest.h>

namespace boresight::orientation {
namespace {

using geomagnetism::Declination;
using geomagnetism::DeclinationBy;

double trueDegrees(const Mounting& mounting, const Declination& declination, double heading)
{
    return Correction(mounting, declination).trueHeading(SensorHeading::folded(Angle::fromDegrees(heading))).degrees();
}

Declination bySite(Angle here)
{
    return {.by = DeclinationBy::Boresight, .here = here};
}

// REQ-ORIENTATION-08 (Correction.*): The declination is never applied twice, even with a sensor that counts against the
// compass.
TEST(Correction, WithoutSettingsTheSensorIsRight)
{
    EXPECT_NEAR(Correction().trueHeading(SensorHeading::folded(-12.67_deg)).degrees(), 347.33, 1e-9);
    EXPECT_NEAR(trueDegrees({}, {}, 347.33), 347.33, 1e-9);
    EXPECT_NEAR(trueDegrees({.azimuthOffset = 37.4_deg}, {}, 347.33), 24.73, 1e-9);
}

// The firmware is built for Berlin: its declination is removed before another is added.
TEST(Correction, NoDeclinationIsAppliedTwice)
{
    EXPECT_NEAR(trueDegrees({}, bySite(-12.5_deg), 105.07), 87.5, 1e-9);
    EXPECT_NEAR(trueDegrees({}, bySite(5.07_deg), 105.07), 105.07, 1e-9);
    EXPECT_NEAR(trueDegrees({}, {.by = DeclinationBy::None}, 105.07), 105.07, 1e-9);
    EXPECT_NEAR(trueDegrees({}, {.by = DeclinationBy::Boresight, .inSensor = Angle{}, .here = 3_deg}, 105.0), 108.0,
                1e-9);
    EXPECT_NEAR(Correction({}, bySite(-12.5_deg)).declination().degrees(), -12.5, 1e-12);
    EXPECT_NEAR(Correction({}, {.by = DeclinationBy::Boresight}).declination().degrees(), 5.07, 1e-12)
        << "one that is not known is not 0";
}

Orientation saying(Angle elevation)
{
    Orientation value;
    value.heading = SensorHeading::folded(40_deg);
    value.extendedAzimuth = 40_deg;
    value.elevation = elevation;
    return value;
}

// REQ-ORIENTATION-971: If the elevation of a sensor falls when the beam rises, it is reversed. For a sensor behind the
// boom an offset of 180° is added. The zeros of a dead sensor stay unchanged.
TEST(Mounting, AnElevationThatCountsDownIsTurnedRound)
{
    const auto beam = [](Angle sent, ElevationSense sense, Angle offset) {
        return Correction({.elevationSense = sense, .elevationOffset = offset}, {})
            .elevation(asMounted(saying(sent), sense, 5.07_deg).elevation)
            .degrees();
    };
    EXPECT_NEAR(beam(30_deg, ElevationSense::Up, 2_deg), 32.0, 1e-9);
    EXPECT_NEAR(beam(60_deg, ElevationSense::Down, 90_deg), 30.0, 1e-9);
    EXPECT_NEAR(beam(150_deg, ElevationSense::Down, 180_deg), 30.0, 1e-9) << "180° - elevation";
    Orientation dead;
    dead.heading = SensorHeading::folded(5.07_deg);
    dead.extendedAzimuth = 5.07_deg;
    dead.temperature = 0.0;
    dead.calibration = Calibration{};
    EXPECT_EQ(asMounted(dead, ElevationSense::Down, 5.07_deg), dead);
}

// Face down the sensor counts against the compass, but an eastern declination is still eastern.
TEST(Correction, ASensorFaceDownCountsBackwards)
{
    const Mounting down{.sense = Sense::CounterClockwise};
    EXPECT_NEAR(trueDegrees(down, {}, 5.07), 5.07, 1e-9);
    EXPECT_NEAR(trueDegrees(down, {}, 35.07), 335.07, 1e-9);
    EXPECT_NEAR(trueDegrees({.sense = Sense::CounterClockwise, .azimuthOffset = 90_deg}, {}, 35.07), 65.07, 1e-9);
}

// Sydney, 12.83° east: true 100° is magnetic 87.17°. Face up the sensor counts this backwards and adds the 5.07° of
// Berlin.
TEST(Correction, ADeclinationIsEastWhicheverWayTheSensorCounts)
{
    const Mounting backwards{.sense = Sense::CounterClockwise};
    const double sent = 5.07 - 87.17;
    EXPECT_NEAR(trueDegrees(backwards, bySite(12.83_deg), sent), 100.0, 1e-9);
    EXPECT_NEAR(trueDegrees(backwards, {.by = DeclinationBy::None}, sent), 87.17 + 5.07, 1e-9)
        << "the sensor's stays in, as for one that counts with the compass";
    EXPECT_NEAR(trueDegrees({}, {.by = DeclinationBy::None}, 5.07 + 87.17), 87.17 + 5.07, 1e-9);
}

TEST(Correction, TheElevationHasItsOwnOffset)
{
    EXPECT_NEAR(Correction({.elevationOffset = -3.5_deg}, {}).elevation(20_deg).degrees(), 16.5, 1e-12);
}

}  // namespace
}  // namespace boresight::orientation
