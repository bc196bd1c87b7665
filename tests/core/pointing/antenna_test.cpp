// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/antenna.h"

#include "core/pointing/mount_model.h"
#include "core/units/angle_between.h"

#include <gtest/gtest.h>

namespace boresight::pointing {
namespace {

const Antenna kBeside{.name = "70 cm", .across = 2_deg, .up = 3_deg};

MountModel mountOf(const PointingTerms& terms)
{
    return {{.travel = {-90_deg, 450_deg}}, {.travel = {-10_deg, 100_deg}}, PointingModel(terms)};
}

// Computed by spherical trigonometry with another program: tan(turn) = tan(across) / cos(elevation), and sin(elevation
// of the beam) = cos(across) sin(elevation).
// REQ-ANTENNA-900: The beam of an antenna lies beside and above the main beam by its offsets. The offset across turns
// the azimuth more at a higher elevation: 2° become 4.0° at 60° and 11.6° at 80°.
TEST(Antenna, IsBesideTheMainBeam)
{
    const SkyPointing beam = mountOf(termsFor({}, kBeside, {})).toSky({100_deg, 57_deg});
    EXPECT_NEAR(beam.azimuth.degrees(), 103.995138, 1e-6);
    EXPECT_NEAR(beam.elevation.degrees(), 59.939601, 1e-6);
    const auto axesOf = [](const SkyPointing& wanted, const Antenna& antenna) {
        return mountOf(termsFor({}, antenna, {})).resolve(wanted, {}).position;
    };
    const AxisPosition high = axesOf({180_deg, 60_deg}, kBeside);
    EXPECT_NEAR(high.azimuth.degrees(), 175.997558, 1e-6);
    EXPECT_NEAR(high.elevation.degrees(), 57.060546, 1e-6);
    const AxisPosition higher = axesOf({180_deg, 80_deg}, {.name = "a", .across = 2_deg});
    EXPECT_NEAR(higher.azimuth.degrees(), 168.405833, 1e-6);
    EXPECT_NEAR(higher.elevation.degrees(), 80.200047, 1e-6);
    const AxisPosition low = axesOf({40_deg, 20_deg}, {.name = "b", .across = -2_deg, .up = -1_deg});
    EXPECT_NEAR(low.azimuth.degrees(), 42.128413, 1e-6);
    EXPECT_NEAR(low.elevation.degrees(), 21.012712, 1e-6);
}

// REQ-ANTENNA-901: The angle between two beams is the same wherever the mount points, also on a leaning mast.
TEST(Antenna, BeamsKeepTheirDistance)
{
    const Antenna other{.name = "23 cm", .across = -1_deg, .up = -5_deg};
    EXPECT_NEAR(beamDistance(kBeside, {}).degrees(), 3.605044, 1e-6);
    EXPECT_NEAR(beamDistance(kBeside, other).degrees(), 8.542862, 1e-6);
    const PointingTerms leaning{.azimuthOffset = 12_deg, .tiltNorth = 1_deg, .tiltEast = -2_deg};
    const MountModel one = mountOf(termsFor(leaning, kBeside, {}));
    const MountModel two = mountOf(termsFor(leaning, other, {}));
    for (const AxisPosition place :
         {AxisPosition{0_deg, 0_deg}, {77_deg, 45_deg}, {200_deg, 88_deg}, {310_deg, 95_deg}}) {
        EXPECT_NEAR(angleBetween(one.toSky(place), two.toSky(place)).degrees(), 8.542862, 1e-6);
    }
    EXPECT_EQ(termsFor(leaning, {}, {}), leaning);
}

// REQ-ANTENNA-902: Without an elevation axis the offset across is an angle of the azimuth.
TEST(Antenna, OfAMountWithOneAxisTurnsTheAzimuth)
{
    const PointingTerms terms = termsFor({.azimuthOffset = 30_deg}, kBeside, Axis::Elevation);
    EXPECT_EQ(terms.azimuthOffset, 32_deg);
    EXPECT_EQ(terms.collimation, 0_deg);
}

}  // namespace
}  // namespace boresight::pointing
