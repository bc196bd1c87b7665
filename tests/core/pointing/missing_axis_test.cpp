// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/missing_axis.h"

#include "core/units/angle_between.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight::pointing {
namespace {

// REQ-MOUNT-11 (MissingAxis.*)
TEST(MissingAxis, TheNearestThatTheBeamCanBeIsThatOverTheWholeMissingAngle)
{
    constexpr double kStep = 0.25;
    for (const double placeElevation : {-1.0, 31.0, 75.0}) {
        const SkyPointing place{.azimuth = 350_deg, .elevation = Angle::fromDegrees(placeElevation)};
        for (double known = 0.0; known < 360.0; known += 7.0) {
            Angle leastUpwards = 180_deg;
            for (double elevation = -90.0; elevation <= 90.0; elevation += kStep) {
                leastUpwards = std::min(
                    leastUpwards, angleBetween({Angle::fromDegrees(known), Angle::fromDegrees(elevation)}, place));
            }
            const Angle upwards = leastAngleBetween({Angle::fromDegrees(known), 0_deg}, place, Axis::Elevation);
            EXPECT_NEAR(upwards.degrees(), leastUpwards.degrees(), kStep) << known;
            EXPECT_LE(upwards, leastUpwards + 1e-6_deg) << known;
        }
        for (double known = -20.0; known <= 90.0; known += 5.0) {
            Angle leastAround = 180_deg;
            for (double azimuth = 0.0; azimuth < 360.0; azimuth += kStep) {
                leastAround = std::min(leastAround,
                                       angleBetween({Angle::fromDegrees(azimuth), Angle::fromDegrees(known)}, place));
            }
            const Angle around = leastAngleBetween({0_deg, Angle::fromDegrees(known)}, place, Axis::Azimuth);
            EXPECT_NEAR(around.degrees(), leastAround.degrees(), 1e-6) << known;
        }
    }
}

}  // namespace
}  // namespace boresight::pointing
