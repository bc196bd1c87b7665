// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/permitted_region.h"

#include "core/pointing/nearest_permitted.h"
#include "tests/core/pointing/at.h"
#include "tests/fakes/random_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace boresight;
using namespace boresight::pointing;

namespace {

constexpr TravelRange kPermittedRegionAzimuths{-200_deg, 460_deg};
constexpr TravelRange kUpright{0_deg, 90_deg};
constexpr TravelRange kPermittedRegionFlipping{0_deg, 180_deg};

AxisBox box(double azimuthMin, double azimuthMax, double elevationMin, double elevationMax)
{
    return AxisBox::between(at(azimuthMin, elevationMin), at(azimuthMax, elevationMax));
}

KeepOut regionMast()
{
    return {.name = "regionMast",
            .azimuthFrom = 300_deg,
            .azimuthTo = 330_deg,
            .elevationMin = 0_deg,
            .elevationMax = 40_deg};
}

// A horizon of 25° all round, and of 0° between azimuth 214° and 262°.
std::vector<HorizonPoint> valley()
{
    return {{210_deg, 25_deg}, {214_deg, 0_deg}, {262_deg, 0_deg}, {266_deg, 25_deg}};
}

void expectPlace(const std::optional<AxisPosition>& place, double azimuth, double elevation)
{
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->azimuth.degrees(), azimuth, 1e-6);
    EXPECT_NEAR(place->elevation.degrees(), elevation, 1e-6);
}

AxisBox widened(const AxisBox& box, double azimuth, double elevation)
{
    const Angle a = Angle::fromDegrees(azimuth);
    const Angle e = Angle::fromDegrees(elevation);
    return {.azimuth = {std::min(box.azimuth.min, box.azimuth.min + a), std::max(box.azimuth.max, box.azimuth.max + a)},
            .elevation = {std::min(box.elevation.min, box.elevation.min + e),
                          std::max(box.elevation.max, box.elevation.max + e)}};
}

}  // namespace

// REQ-POINTING-11: Limits apply to axis angles. Horizon and keep-outs apply on every wrap, through north and over the
// top. Their edges are permitted.
TEST(PermittedRegion, LimitsAndTravelHoldTogether)
{
    const PermittedRegion region({.azimuth = {-90_deg, 600_deg}, .elevation = {5_deg, 80_deg}},
                                 kPermittedRegionAzimuths, kUpright);
    EXPECT_TRUE(region.permits(at(-90, 5)));
    EXPECT_TRUE(region.permits(at(460, 80)));
    EXPECT_FALSE(region.permits(at(-90.001, 5)));
    EXPECT_FALSE(region.permits(at(460.001, 5)));
    EXPECT_FALSE(region.permits(at(0, 4.999)));
    EXPECT_EQ(region.reason(at(-100, 10)).toStdString(), "azimuth axis -100.0° outside limits -90.0°…460.0°");
    EXPECT_EQ(region.reason(at(0, 85)).toStdString(), "elevation 85.0° outside limits 5.0°…80.0°");
    EXPECT_EQ(region.obstacle(at(-100, 10)).toStdString(), "the azimuth axis limit -90.0°");
    EXPECT_EQ(region.reason(at(0, 10)).toStdString(), "");
}

TEST(PermittedRegion, LimitsWithNothingInCommonPermitNothing)
{
    const PermittedRegion region({.azimuth = {500_deg, 600_deg}}, kPermittedRegionAzimuths, kUpright);
    EXPECT_FALSE(region.permits(at(460, 10)));
    EXPECT_FALSE(region.permits(at(500, 10)));
    EXPECT_FALSE(nearestPermitted(region, at(460, 10)));
}

// REQ-POINTING-11
TEST(PermittedRegion, AKeepOutHoldsOnEveryTurnAndOverTheTop)
{
    const PermittedRegion region({.keepOuts = {regionMast()}}, kPermittedRegionAzimuths, kPermittedRegionFlipping);
    for (const double azimuth : {315.0, -45.0}) {
        EXPECT_FALSE(region.permits(at(azimuth, 10)));
        EXPECT_TRUE(region.permits(at(azimuth, 40)));  // its edge
        EXPECT_TRUE(region.permits(at(azimuth, 170)));
    }
    for (const double azimuth : {135.0, 125.0}) {
        EXPECT_TRUE(region.permits(at(azimuth, 10)));
        EXPECT_FALSE(region.permits(at(azimuth, 170)));  // backwards at 315°, 10°
        EXPECT_TRUE(region.permits(at(azimuth, 140)));
    }
    EXPECT_TRUE(region.permits(at(300, 10)));
    EXPECT_TRUE(region.permits(at(-30, 10)));
    EXPECT_EQ(region.reason(at(315, 10)).toStdString(), "315.0° / 10.0° lies in keep-out \"regionMast\"");
    EXPECT_EQ(region.obstacle(at(135, 170)).toStdString(), "the keep-out \"regionMast\"");
}

// REQ-POINTING-11
TEST(PermittedRegion, AKeepOutThroughNorth)
{
    const PermittedRegion region({.keepOuts = {{"chimney", 350_deg, 10_deg, 20_deg, 50_deg}}}, kPermittedRegionAzimuths,
                                 kUpright);
    for (const double azimuth : {355.0, 0.0, 5.0, 360.0, 365.0, -5.0}) {
        EXPECT_FALSE(region.permits(at(azimuth, 30))) << azimuth;
    }
    for (const double azimuth : {349.0, 11.0, 180.0, 371.0, -11.0}) {
        EXPECT_TRUE(region.permits(at(azimuth, 30))) << azimuth;
    }
}

// REQ-POINTING-13
TEST(PermittedRegion, AKeepOutAllRoundTheZenithHasNoEdgeInItsMiddle)
{
    const PermittedRegion region({.keepOuts = {{"ice", 0_deg, 360_deg, 80_deg, 90_deg}}}, kPermittedRegionAzimuths,
                                 kPermittedRegionFlipping);
    EXPECT_FALSE(region.permits(at(0, 90)));
    EXPECT_FALSE(region.permits(at(460, 90)));
    EXPECT_TRUE(region.permits(at(10, 80)));
    EXPECT_TRUE(region.permits(at(10, 100)));
}

// REQ-POINTING-11
TEST(PermittedRegion, TheHorizonIsStraightBetweenItsPoints)
{
    const PermittedRegion region({.horizon = valley()}, kPermittedRegionAzimuths, kPermittedRegionFlipping);
    EXPECT_FALSE(region.permits(at(0, 24.9)));
    EXPECT_TRUE(region.permits(at(0, 25)));
    EXPECT_TRUE(region.permits(at(240, 0)));
    EXPECT_TRUE(region.permits(at(212, 12.5)));
    EXPECT_FALSE(region.permits(at(212, 12.4)));
    EXPECT_TRUE(region.permits(at(212 - 360, 12.5)));
    EXPECT_TRUE(region.permits(at(60, 180)));    // backwards into the valley
    EXPECT_FALSE(region.permits(at(240, 170)));  // backwards at 60°, 10°
    EXPECT_TRUE(region.permits(at(240, 155)));
    EXPECT_EQ(region.reason(at(200, 3)).toStdString(), "200.0° / 3.0° lies below the horizon (25.0°)");
    EXPECT_EQ(region.reason(at(20, 177)).toStdString(), "200.0° / 3.0° lies below the horizon (25.0°)");
    EXPECT_EQ(region.obstacle(at(200, 3)).toStdString(), "the horizon");
}

// REQ-POINTING-12: A box is permitted only if all of it is permitted. It can be widened exactly up to the obstacle.
TEST(PermittedRegion, ABoxIsPermittedOnlyWithAllOfIt)
{
    const PermittedRegion region({.horizon = valley(), .keepOuts = {regionMast()}}, kPermittedRegionAzimuths, kUpright);
    EXPECT_TRUE(region.permits(box(220, 260, 0, 90)));
    EXPECT_FALSE(region.permits(box(213, 260, 0, 90)));
    EXPECT_TRUE(region.permits(box(213, 260, 6.25, 90)));
    EXPECT_FALSE(region.permits(box(290, 340, 30, 35)));  // its corners are permitted
    EXPECT_TRUE(region.permits(box(-200, 460, 40, 90)));
    EXPECT_FALSE(region.permits(box(-200, 460, 39.9, 90)));
}

// REQ-POINTING-13: There is no way between two forbidden areas that touch.
TEST(PermittedRegion, ThereIsNoWayBetweenWhatTouches)
{
    const KeepOut left{"left", 300_deg, 310_deg, 10_deg, 40_deg};
    const KeepOut right{"right", 310_deg, 330_deg, 0_deg, 30_deg};
    const KeepOut above{"above", 305_deg, 330_deg, 40_deg, 50_deg};
    const PermittedRegion region({.keepOuts = {left, right, above}}, kPermittedRegionAzimuths, kUpright);
    EXPECT_FALSE(region.permits(at(310, 20)));
    EXPECT_TRUE(region.permits(at(310, 35)));  // the part of the side of `left` that is not beside `right`
    EXPECT_FALSE(region.permits(at(307, 40)));
    EXPECT_FALSE(region.permits(at(320, 0)));  // below `right` is the end of the travel
    EXPECT_TRUE(region.permits(at(305, 5)));
}

// REQ-POINTING-13
TEST(PermittedRegion, ThereIsNoWayBelowAKeepOutThatStandsOnTheHorizon)
{
    const KeepOut roof{"roof", 40_deg, 80_deg, 20_deg, 30_deg};
    const PermittedRegion region({.horizon = {{0_deg, 20_deg}, {60_deg, 20_deg}, {90_deg, 5_deg}}, .keepOuts = {roof}},
                                 kPermittedRegionAzimuths, kUpright);
    EXPECT_FALSE(region.permits(at(50, 20)));
    EXPECT_FALSE(region.permits(at(60, 20)));
    EXPECT_TRUE(region.permits(at(70, 18)));  // there the horizon falls away below this point
    EXPECT_TRUE(region.permits(at(40, 20)));
}

// REQ-POINTING-14: For a forbidden position the nearest permitted one is found, with the reason.
TEST(PermittedRegion, NearestPlaces)
{
    const PermittedRegion region({.horizon = valley(), .keepOuts = {regionMast()}}, kPermittedRegionAzimuths,
                                 kPermittedRegionFlipping);
    expectPlace(nearestPermitted(region, at(100, 50)), 100, 50);
    expectPlace(nearestPermitted(region, at(100, 10)), 100, 25);
    expectPlace(nearestPermitted(region, at(315, 38)), 315, 40);
    expectPlace(nearestPermitted(region, at(301, 30)), 300, 30);
    expectPlace(nearestPermitted(region, at(301 - 360, 30)), -60, 30);
    expectPlace(nearestPermitted(region, at(315, 10)), 300, 25);    // the side of the mast, above the horizon
    expectPlace(nearestPermitted(region, at(470, 200)), 442, 180);  // backwards, at the end of the valley
    // the horizon is at 18.75° there: across to its falling line
    const auto foot = nearestPermitted(region, at(211, 10));
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->elevation.degrees(), 25.0 - (foot->azimuth.degrees() - 210.0) * 6.25, 1e-6);
    EXPECT_GT(foot->azimuth, 212_deg);
    EXPECT_LT(foot->elevation, 10.5_deg);
}

// Random regions compared with a simple independent computation.
// REQ-POINTING-11
TEST(PermittedRegion, AgreesWithThePlainTruth)
{
    std::mt19937 random(20261121);
    fakes::RandomRegion make(random);
    int permitted = 0;
    int forbidden = 0;
    for (int round = 0; round < 300; ++round) {
        const Region region = make.region();
        const TravelRange azimuths = make.azimuthTravel();
        const TravelRange elevations = make.elevationTravel();
        const PermittedRegion prepared(region, azimuths, elevations);
        for (int i = 0; i < 300; ++i) {
            const AxisPosition place = make.place(azimuths, elevations);
            const double depth = fakes::depthInside(region, place);
            if (std::abs(depth) > 0.06) {  // narrow gaps are closed
                EXPECT_EQ(prepared.permits(place), depth < 0) << round << ": " << place.azimuth.degrees() << ", "
                                                              << place.elevation.degrees() << " depth " << depth;
                EXPECT_EQ(prepared.reason(place).isEmpty(), depth < 0);
                ++(depth < 0 ? permitted : forbidden);
            }
        }
    }
    EXPECT_GT(permitted, 10000);
    EXPECT_GT(forbidden, 10000);
}

// REQ-POINTING-12
TEST(PermittedRegion, WidestBoxesArePermittedAndNoWiderOnes)
{
    std::mt19937 random(7);
    fakes::RandomRegion make(random);
    int checked = 0;
    for (int round = 0; round < 200; ++round) {
        const PermittedRegion region(make.region(), make.azimuthTravel(), make.elevationTravel());
        const AxisBox& ranges = region.ranges();
        for (int i = 0; i < 100 && ranges.azimuth.min < ranges.azimuth.max; ++i) {
            const AxisPosition place = make.place(ranges.azimuth, ranges.elevation);
            const AxisPosition other = make.place(ranges.azimuth, ranges.elevation);
            AxisBox box = AxisBox::between(place, {place.azimuth + 0.05 * (other.azimuth - place.azimuth),
                                                   place.elevation + 0.05 * (other.elevation - place.elevation)});
            if (!region.permits(box)) {
                continue;
            }
            ++checked;
            box.azimuth = region.azimuthsAround(box);
            EXPECT_TRUE(region.permits(box));
            EXPECT_FALSE(region.permits(widened(box, 1e-4, 0)));
            EXPECT_FALSE(region.permits(widened(box, -1e-4, 0)));
            box.elevation = region.elevationsAround(box);
            EXPECT_TRUE(region.permits(box));
            EXPECT_FALSE(region.permits(widened(box, 0, 1e-4)));
            EXPECT_FALSE(region.permits(widened(box, 0, -1e-4)));
        }
    }
    EXPECT_GT(checked, 3000);
}

// REQ-POINTING-14
TEST(PermittedRegion, NothingPermittedIsNearerThanTheNearest)
{
    std::mt19937 random(11);
    fakes::RandomRegion make(random);
    int checked = 0;
    for (int round = 0; round < 200; ++round) {
        const TravelRange azimuths = make.azimuthTravel();
        const TravelRange elevations = make.elevationTravel();
        const PermittedRegion region(make.region(), azimuths, elevations);
        for (int i = 0; i < 20; ++i) {
            const AxisPosition wanted = make.place(azimuths, elevations);
            const auto nearest = nearestPermitted(region, wanted);
            if (!nearest || *nearest == wanted) {
                continue;
            }
            ++checked;
            EXPECT_TRUE(region.permits(*nearest));
            const double width = std::max(0.05, std::abs(std::cos(wanted.elevation.radians())));
            const auto distance = [&](const AxisPosition& place) {
                return std::hypot(width * (place.azimuth - wanted.azimuth).degrees(),
                                  (place.elevation - wanted.elevation).degrees());
            };
            const double least = distance(*nearest);
            for (int j = 0; j < 200; ++j) {
                const double angle = make.uniform(0, 6.2832);
                const double far = make.uniform(0, 0.999) * least;
                const AxisPosition other{wanted.azimuth + Angle::fromDegrees(far * std::cos(angle) / width),
                                         wanted.elevation + Angle::fromDegrees(far * std::sin(angle))};
                EXPECT_FALSE(region.permits(other)) << least << " but " << distance(other);
            }
        }
    }
    EXPECT_GT(checked, 500);
}
