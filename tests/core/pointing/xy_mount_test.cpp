// SPDX-License-Identifier: GPL-3.0-or-later
// A mount with the axes X and Y.
#include "core/pointing/mount_model.h"
#include "core/pointing/nearest_permitted.h"
#include "core/pointing/permitted_region.h"
#include "core/pointing/pointing_model.h"
#include "core/pointing/route.h"
#include "core/units/angle_between.h"
#include "tests/core/pointing/at.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace boresight;
using namespace boresight::pointing;

namespace {

constexpr double kExactXY = 1e-9;  // °
constexpr TravelRange kQuarters{-90_deg, 90_deg};

PointingModel xyModel(Angle xAxis = 0_deg)
{
    return PointingModel(PointingTerms{.geometry = {.kind = Geometry::XY, .xAxis = xAxis}});
}

SkyPointing towards(double azimuth, double elevation)
{
    return {.azimuth = Angle::fromDegrees(azimuth), .elevation = Angle::fromDegrees(elevation)};
}

void expectXY(Angle xAxis, const SkyPointing& direction, double x, double y)
{
    const PointingModel model = xyModel(xAxis);
    const Aim aim = model.toAxes(direction);
    EXPECT_NEAR(aim.axes.azimuth.degrees(), x, 1e-6) << direction.azimuth.degrees();
    EXPECT_NEAR(aim.axes.elevation.degrees(), y, 1e-6) << direction.azimuth.degrees();
    EXPECT_TRUE(aim.exact());
    EXPECT_LT(angleBetween(model.toSky(aim.axes), direction).degrees(), 1e-6);
}

MountModel xyMount(const TravelRange& x = kQuarters, const TravelRange& y = kQuarters)
{
    return {AxisGeometry{.travel = x}, AxisGeometry{.travel = y}, xyModel()};
}

PermittedRegion xyRegion(const Region& region, const TravelRange& x = kQuarters, const TravelRange& y = kQuarters)
{
    return {region, x, y, xyModel()};
}

Region level(Angle elevation)
{
    return {.horizon = {{.azimuth = 0_deg, .elevation = elevation}}, .keepOuts = {}};
}

// A horizon of hills, between 2° and 25°.
Region hills()
{
    Region region;
    for (int azimuth = 0; azimuth < 360; azimuth += 10) {
        const double height = 8.0 + 5.0 * std::sin(azimuth * 0.11) + (azimuth == 60 || azimuth == 250 ? 12.0 : 0.0);
        region.horizon.push_back({Angle::fromDegrees(azimuth), Angle::fromDegrees(height)});
    }
    region.keepOuts = {
        {.name = "mast", .azimuthFrom = 130_deg, .azimuthTo = 150_deg, .elevationMin = 0_deg, .elevationMax = 50_deg},
        {.name = "roof", .azimuthFrom = 340_deg, .azimuthTo = 20_deg, .elevationMin = 30_deg, .elevationMax = 60_deg}};
    return region;
}

bool isForbidden(const Region& region, const Skyline& skyline, const SkyPointing& beam)
{
    for (const KeepOut& keepOut : region.keepOuts) {
        const Angle into = (beam.azimuth - keepOut.azimuthFrom).wrapped360();
        if (into > 0_deg && into < (keepOut.azimuthTo - keepOut.azimuthFrom).wrapped360() &&
            beam.elevation > keepOut.elevationMin && beam.elevation < keepOut.elevationMax) {
            return true;
        }
    }
    return beam.elevation < skyline.at(beam.azimuth);
}

}  // namespace

// With an X axis that lies north-south, XEYN: X leans the beam to the east, Y to the north. At 45° of elevation in the
// north-east, tan X = sin 45° and sin Y = cos 45° cos 45°.
// REQ-POINTING-51: The axes of an X/Y mount are those of CCSDS 503.0-B: XEYN for an X axis to the north, XSYE for one
// to the east, and any other azimuth of the X axis. Both conversions are exact.
TEST(XYMount, NorthSouthIsXEYN)
{
    expectXY(0_deg, towards(0, 90), 0.0, 0.0);
    expectXY(0_deg, towards(90, 30), 60.0, 0.0);
    expectXY(0_deg, towards(270, 30), -60.0, 0.0);
    expectXY(0_deg, towards(0, 30), 0.0, 60.0);
    expectXY(0_deg, towards(180, 10), 0.0, -80.0);
    expectXY(0_deg, towards(45, 45), 35.264389683, 30.0);
    expectXY(0_deg, towards(225, 45), -35.264389683, -30.0);
    expectXY(0_deg, towards(90, 0), 90.0, 0.0);
}

// With an X axis that lies east-west, XSYE: X leans the beam to the south, Y to the east.
// REQ-POINTING-51
TEST(XYMount, EastWestIsXSYE)
{
    expectXY(90_deg, towards(180, 30), 60.0, 0.0);
    expectXY(90_deg, towards(0, 30), -60.0, 0.0);
    expectXY(90_deg, towards(90, 30), 0.0, 60.0);
    expectXY(90_deg, towards(135, 45), 35.264389683, 30.0);
}

// REQ-POINTING-51
TEST(XYMount, TheXAxisMayLieInAnyDirection)
{
    expectXY(30_deg, towards(75, 45), 35.264389683, 30.0);
    expectXY(211.5_deg, towards(211.5, 20), 0.0, 70.0);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(0.0, 1.0);
    for (int i = 0; i < 2000; ++i) {
        const PointingModel model = xyModel(Angle::fromDegrees(360.0 * any(random)));
        const AxisPosition axes = at(358.0 * any(random) - 179.0, 178.0 * any(random) - 89.0);
        const SkyPointing sky = model.toSky(axes);
        EXPECT_GE(sky.azimuth, 0_deg);
        EXPECT_LT(sky.azimuth, 360_deg);
        const AxisPosition back = model.toAxes(sky).axes;
        EXPECT_NEAR(back.azimuth.degrees(), axes.azimuth.degrees(), 1e-7);
        EXPECT_NEAR(back.elevation.degrees(), axes.elevation.degrees(), 1e-7);
    }
}

// A pass across the zenith from east to west needs X only, at the rate of the satellite. Near the horizon in the north
// 1° of azimuth needs many degrees of X: dX = dA cos E cos A sin E / (cos² Y), which grows as 1 / cos Y.
// REQ-POINTING-52: An X/Y mount has its keyhole at the horizon, at both ends of the X axis, and none at the zenith.
TEST(XYMount, TheKeyholeIsAtTheHorizonAtBothEndsOfTheXAxis)
{
    const PointingModel model = xyModel();
    EXPECT_NEAR((model.toAxes(towards(90, 89)).axes.azimuth - model.toAxes(towards(270, 89)).axes.azimuth).degrees(),
                2.0, kExactXY);
    for (const double end : {0.0, 180.0}) {
        const AxisPosition left = model.toAxes(towards(end - 1.0, 1.0)).axes;
        const AxisPosition right = model.toAxes(towards(end + 1.0, 1.0)).axes;
        EXPECT_NEAR(abs(right.azimuth - left.azimuth).degrees(), 90.0, 0.1);
        EXPECT_GT(abs(left.elevation).degrees(), 88.5);
    }
}

// REQ-POINTING-53: Limits of X and Y apply as limits of an axis. An X/Y mount has no turns of a cable and no way over
// the top. A direction that it cannot reach is answered with the nearest place and the axis that ends.
TEST(XYMount, LimitsAreThoseOfXAndY)
{
    const MountModel model = xyMount({-80_deg, 80_deg}, {-70_deg, 70_deg});
    const Resolved free = model.resolve(towards(45, 45), at(0, 0));
    EXPECT_FALSE(free.limited);
    EXPECT_NEAR(free.position.azimuth.degrees(), 35.264389683, 1e-6);

    const Resolved east = model.resolve(towards(90, 5), at(0, 0));
    EXPECT_TRUE(east.limited);
    EXPECT_EQ(east.reason.toStdString(), "X axis 85.0° above limit 80.0°");
    EXPECT_NEAR(east.position.azimuth.degrees(), 80.0, kExactXY);

    const Resolved north = model.resolve(towards(0, 5), at(0, 0));
    EXPECT_TRUE(north.limited);
    EXPECT_EQ(north.reason.toStdString(), "Y axis 85.0° above limit 70.0°");
    EXPECT_NEAR(north.position.elevation.degrees(), 70.0, kExactXY);

    // Below the horizon in the west: X would be -95°.
    const Resolved below = model.resolve(towards(270, -5), at(0, 0));
    EXPECT_EQ(below.reason.toStdString(), "X axis -95.0° below limit -80.0°");
    EXPECT_NEAR(below.position.azimuth.degrees(), -80.0, kExactXY);

    // 100° of elevation is the direction on the other side, not a way over the top.
    const Resolved over = model.resolve(towards(90, 100), at(0, 0));
    EXPECT_FALSE(over.limited);
    EXPECT_NEAR(over.position.azimuth.degrees(), -10.0, 1e-6);
    EXPECT_EQ(model.resolve(at(81, -71)).reason.toStdString(),
              "X axis 81.0° above limit 80.0°, Y axis -71.0° below limit -70.0°");
}

// REQ-POINTING-54: Horizon and keep-outs hold on an X/Y mount: no permitted place points into them. At most 2° beside
// them is forbidden, too.
TEST(XYMount, NoPermittedPlaceIsForbidden)
{
    for (const Region& drawn : {level(5_deg), level(20_deg), hills()}) {
        const PermittedRegion region = xyRegion(drawn, {-95_deg, 95_deg});
        const Skyline skyline(drawn.horizon);
        const PointingModel model = xyModel();
        std::mt19937 random(7);
        std::uniform_real_distribution<double> x(-95.0, 95.0);
        std::uniform_real_distribution<double> y(-90.0, 90.0);
        int permitted = 0;
        int lost = 0;
        for (int i = 0; i < 5000; ++i) {
            const AxisPosition place = at(x(random), y(random));
            const SkyPointing beam = model.toSky(place);
            if (region.permits(place)) {
                ++permitted;
                EXPECT_FALSE(isForbidden(drawn, skyline, beam)) << beam.azimuth.degrees() << beam.elevation.degrees();
                EXPECT_TRUE(region.reason(place).isEmpty());
                continue;
            }
            EXPECT_FALSE(region.reason(place).isEmpty());
            // A place is lost if nothing forbidden is within 2° of it.
            bool near = false;
            for (int k = 0; k < 36 && !near; ++k) {
                const double around = k * 10.0 * 3.14159265358979 / 180.0;
                const double up = std::clamp(beam.elevation.degrees() + 2.0 * std::cos(around), -90.0, 90.0);
                const double aside = 2.0 * std::sin(around) / std::max(0.05, std::cos(beam.elevation.radians()));
                near = isForbidden(drawn, skyline, towards(beam.azimuth.degrees() + aside, up)) ||
                       isForbidden(drawn, skyline, beam);
            }
            lost += near ? 0 : 1;
        }
        EXPECT_GT(permitted, 2000);
        EXPECT_LT(lost, 5);  // behind a slit that is closed
        EXPECT_LT(region.keepOuts().size(), 300U);
    }
}

// REQ-POINTING-54
TEST(XYMount, TheReasonNamesTheObstacle)
{
    const PermittedRegion region = xyRegion(hills());
    const PointingModel model = xyModel();
    EXPECT_EQ(region.reason(model.toAxes(towards(140, 30)).axes).toStdString(),
              "140.0° / 30.0° lies in keep-out \"mast\"");
    EXPECT_EQ(region.obstacle(model.toAxes(towards(140, 30)).axes).toStdString(), "the keep-out \"mast\"");
    EXPECT_EQ(region.obstacle(model.toAxes(towards(60, 3)).axes).toStdString(), "the horizon");
    EXPECT_EQ(region.reason(at(91, 0)).toStdString(), "X axis 91.0° outside limits -90.0°…90.0°");
    EXPECT_EQ(region.obstacle(at(0, -91)).toStdString(), "the Y axis limit -90.0°");
}

// REQ-POINTING-55: A way of an X/Y mount leads around the horizon and the keep-outs, and every box of it is permitted.
TEST(XYMount, AWayLeadsAroundWhatIsForbidden)
{
    const PermittedRegion region = xyRegion(hills());
    const PointingModel model = xyModel();
    std::mt19937 random(11);
    std::uniform_real_distribution<double> azimuth(0.0, 360.0);
    std::uniform_real_distribution<double> elevation(0.0, 90.0);
    constexpr AxisRates kRates{.azimuth = 6_deg_s, .elevation = 6_deg_s};
    int ways = 0;
    for (int i = 0; i < 100; ++i) {
        const auto from = nearestPermitted(region, model.toAxes(towards(azimuth(random), elevation(random))).axes);
        const auto to = nearestPermitted(region, model.toAxes(towards(azimuth(random), elevation(random))).axes);
        ASSERT_TRUE(from && to);
        const auto way = route(region, *from, *to, kRates);
        ASSERT_TRUE(way) << textOf(way.error());
        AxisPosition here = *from;
        for (const AxisPosition& place : *way) {
            EXPECT_TRUE(region.permits(AxisBox::between(here, place)));
            here = place;
        }
        EXPECT_EQ(here, *to);
        ways += way->size() > 1 ? 1 : 0;
    }
    EXPECT_GT(ways, 7);
}
