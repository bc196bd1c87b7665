// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/correction.h"

#include <gtest/gtest.h>

namespace boresight::orientation {
namespace {

double trueDegrees(const CorrectionSettings& settings, double heading)
{
    return Correction(settings).trueHeading(SensorHeading::folded(Angle::fromDegrees(heading))).degrees();
}

TEST(Correction, WithoutSettingsTheSensorIsRight)
{
    EXPECT_NEAR(trueDegrees({}, 347.33), 347.33, 1e-9);
    EXPECT_NEAR(trueDegrees({.azimuthOffset = 37.4_deg}, 347.33), 24.73, 1e-9);
}

// The firmware is built for Berlin: what it adds is taken off before another is added.
TEST(Correction, NoDeclinationIsAppliedTwice)
{
    const CorrectionSettings ofSite{.declination = Declination::OfSite, .ofSite = -12.5_deg};
    EXPECT_NEAR(trueDegrees(ofSite, 105.07), 87.5, 1e-9);
    EXPECT_NEAR(trueDegrees({.declination = Declination::None}, 105.07), 100.0, 1e-9);
    const CorrectionSettings same{.declination = Declination::OfSite, .ofSite = 5.07_deg};
    EXPECT_NEAR(trueDegrees(same, 105.07), 105.07, 1e-9);
    const CorrectionSettings ofOwnFirmware{.declination = Declination::OfSite, .ofSensor = Angle{}, .ofSite = 3_deg};
    EXPECT_NEAR(trueDegrees(ofOwnFirmware, 105.0), 108.0, 1e-9);
}

// Face down the sensor turns against the compass, but a declination is east all the same.
TEST(Correction, ASensorFaceDownCountsBackwards)
{
    const CorrectionSettings down{.sense = Sense::CounterClockwise};
    EXPECT_NEAR(trueDegrees(down, 5.07), 5.07, 1e-9);
    EXPECT_NEAR(trueDegrees(down, 35.07), 335.07, 1e-9);
    const CorrectionSettings offset{.sense = Sense::CounterClockwise, .azimuthOffset = 90_deg};
    EXPECT_NEAR(trueDegrees(offset, 35.07), 65.07, 1e-9);
}

TEST(Correction, TheElevationHasItsOwnOffset)
{
    EXPECT_NEAR(Correction({.elevationOffset = -3.5_deg}).elevation(20_deg).degrees(), 16.5, 1e-12);
}

}  // namespace
}  // namespace boresight::orientation
