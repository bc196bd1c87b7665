// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/sun_keep_out.h"

#include "core/pointing/permitted_region.h"
#include "core/pointing/route.h"
#include "core/units/angle_between.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace boresight;
using namespace boresight::pointing;

namespace {

constexpr TravelRange kSunKeepOutAzimuths{-90_deg, 450_deg};
constexpr TravelRange kSunKeepOutFlipping{-5_deg, 180_deg};

PermittedRegion regionAround(const SkyPointing& sun, Angle radius)
{
    const auto keepOut = sunKeepOut(sun, radius);
    return PermittedRegion(withSun({}, keepOut ? std::vector{*keepOut} : std::vector<KeepOut>{}), kSunKeepOutAzimuths,
                           kSunKeepOutFlipping);
}

// The direction at this distance from the Sun. `around` is the angle around the Sun, from straight up.
SkyPointing beside(const SkyPointing& sun, Angle distance, double around)
{
    const double elevation = sun.elevation.radians();
    const double away = distance.radians();
    const double height =
        std::asin(std::sin(elevation) * std::cos(away) + std::cos(elevation) * std::sin(away) * std::cos(around));
    const double turn = std::atan2(std::sin(around) * std::sin(away) * std::cos(elevation),
                                   std::cos(away) - std::sin(elevation) * std::sin(height));
    return {.azimuth = (sun.azimuth + Angle::fromRadians(turn)).wrapped360(), .elevation = Angle::fromRadians(height)};
}

}  // namespace

// While the Sun is up, no permitted position of the axes points into the circle, on any wrap and over the top.
// REQ-POINTING-21 (SunKeepOut.*): The Sun is a keep-out: no permitted position points into the circle around it, near
// the zenith from any azimuth. There is no keep-out while the Sun is down.
TEST(SunKeepOut, NoPlaceLooksIntoTheCircle)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
        const SkyPointing sun{.azimuth = Angle::fromDegrees(360.0 * unit(random)),
                              .elevation = Angle::fromDegrees(-2.0 + 92.0 * unit(random))};
        const Angle radius = Angle::fromDegrees(0.5 + 30.0 * unit(random));
        const SkyPointing looked = beside(sun, 0.999 * std::sqrt(unit(random)) * radius, 6.3 * unit(random));
        ASSERT_LT(angleBetween(sun, looked), radius);
        if (looked.elevation < kSunKeepOutFlipping.min) {
            continue;
        }
        const PermittedRegion region = regionAround(sun, radius);
        EXPECT_FALSE(region.permits(AxisPosition{looked.azimuth, looked.elevation}));
        EXPECT_FALSE(region.permits(AxisPosition{looked.azimuth + 360_deg, looked.elevation})) << "another turn";
        const AxisPosition overTheTop{(looked.azimuth + 180_deg).wrapped360(), 180_deg - looked.elevation};
        EXPECT_FALSE(region.permits(overTheTop));
    }
}

// The keep-out is as small as possible: each of its sides touches the circle.
TEST(SunKeepOut, TouchesTheCircle)
{
    const SkyPointing sun{.azimuth = 350_deg, .elevation = 60_deg};
    const KeepOut keepOut = sunKeepOut(sun, 10_deg).value();
    EXPECT_NEAR(keepOut.elevationMin.degrees(), 50.0, 1e-9);
    EXPECT_NEAR(keepOut.elevationMax.degrees(), 70.0, 1e-9);
    const Angle touching = Angle::fromRadians(std::asin(std::sin(sun.elevation.radians()) / std::cos(0.1745329252)));
    EXPECT_NEAR(angleBetween(sun, {.azimuth = keepOut.azimuthFrom, .elevation = touching}).degrees(), 10.0, 1e-6);
    EXPECT_NEAR(angleBetween(sun, {.azimuth = keepOut.azimuthTo, .elevation = touching}).degrees(), 10.0, 1e-6);
    EXPECT_GT(keepOut.azimuthFrom, keepOut.azimuthTo) << "through north";
    EXPECT_EQ(keepOut.name, "Sun");
}

TEST(SunKeepOut, NearTheZenithTakesAllAzimuths)
{
    for (const Angle elevation : {80_deg, 85_deg, 90_deg}) {
        const SkyPointing sun{.azimuth = 123_deg, .elevation = elevation};
        const PermittedRegion region = regionAround(sun, 10_deg);
        for (double azimuth = 0.0; azimuth < 360.0; azimuth += 15.0) {
            EXPECT_FALSE(region.permits(AxisPosition{Angle::fromDegrees(azimuth), elevation - 9.9_deg}));
            EXPECT_FALSE(region.permits(AxisPosition{Angle::fromDegrees(azimuth), 90_deg})) << "the zenith is no gap";
            EXPECT_TRUE(region.permits(AxisPosition{Angle::fromDegrees(azimuth), elevation - 10.1_deg}));
        }
    }
}

// Just before the circle reaches the zenith the keep-out is wide, and the zenith is still permitted.
TEST(SunKeepOut, IsWideBeforeTheZenith)
{
    const KeepOut keepOut = sunKeepOut({.azimuth = 180_deg, .elevation = 79.9_deg}, 10_deg).value();
    EXPECT_GT((keepOut.azimuthTo - keepOut.azimuthFrom).degrees(), 160.0);
    EXPECT_LT(keepOut.elevationMax, 90_deg);
}

TEST(SunKeepOut, IsNoneWhileTheSunIsDown)
{
    EXPECT_FALSE(sunKeepOut({.azimuth = 250_deg, .elevation = -2.01_deg}, 20_deg));
    EXPECT_FALSE(sunKeepOut({.azimuth = 250_deg, .elevation = -60_deg}, 20_deg));
    const auto low = sunKeepOut({.azimuth = 250_deg, .elevation = -1_deg}, 20_deg);
    ASSERT_TRUE(low);
    EXPECT_NEAR(low->elevationMin.degrees(), -21.0, 1e-9);
}

// A step into the circle is refused, a sweep across it too, and a route leads around it.
TEST(SunKeepOut, HoldsForStepsAndWays)
{
    const SkyPointing sun{.azimuth = 180_deg, .elevation = 40_deg};
    const PermittedRegion region = regionAround(sun, 8_deg);
    const AxisPosition before{.azimuth = 150_deg, .elevation = 40_deg};
    const AxisPosition behind{.azimuth = 210_deg, .elevation = 40_deg};
    EXPECT_FALSE(region.permits(AxisBox::between(before, behind)));
    EXPECT_EQ(region.obstacle({sun.azimuth, sun.elevation}).toStdString(), "the keep-out \"Sun\"");
    const auto way = route(region, before, behind, {.azimuth = 6_deg_s, .elevation = 6_deg_s});
    ASSERT_TRUE(way) << textOf(way.error());
    AxisPosition from = before;
    for (const AxisPosition& to : *way) {
        EXPECT_TRUE(region.permits(AxisBox::between(from, to)));
        from = to;
    }
    EXPECT_GT(way->size(), 1U);
    EXPECT_FALSE(route(region, before, {.azimuth = 181_deg, .elevation = 41_deg}, {6_deg_s, 6_deg_s}));
}

// The Sun at any declination and hour angle, while it is up: directions in the circle around it are forbidden, on a
// leaning mount, too.
// REQ-POINTING-21a (SunBand.*): Without a trusted clock no permitted position points into the circle around any place
// that the Sun can have at this latitude. What the Sun never reaches stays permitted.
TEST(SunBand, NoPlaceLooksIntoTheCircleAtAnyTime)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    constexpr Angle kRadius = 10_deg;
    const PointingModel leaning({.azimuthOffset = 37_deg, .tiltNorth = 0.8_deg, .collimation = 0.3_deg});
    int seen = 0;
    for (const double latitude : {-67.0, -33.5, 0.0, 12.0, 38.757, 52.0, 78.0, 90.0}) {
        const double north = latitude * std::numbers::pi / 180.0;
        const Region drawn = withSun({}, sunBand(Angle::fromDegrees(latitude), kRadius));
        const PermittedRegion region(drawn, kSunKeepOutAzimuths, kSunKeepOutFlipping);
        const PermittedRegion leant(drawn, kSunKeepOutAzimuths, kSunKeepOutFlipping, leaning);
        for (int i = 0; i < 3000; ++i) {
            const double declination = (2.0 * unit(random) - 1.0) * 23.44 * std::numbers::pi / 180.0;
            const double hour = 2.0 * std::numbers::pi * unit(random);
            const double height = std::asin(std::sin(north) * std::sin(declination) +
                                            std::cos(north) * std::cos(declination) * std::cos(hour));
            const double east = -std::cos(declination) * std::sin(hour);
            const double ahead =
                std::sin(declination) * std::cos(north) - std::cos(declination) * std::cos(hour) * std::sin(north);
            const SkyPointing sun{.azimuth = Angle::fromRadians(std::atan2(east, ahead)).wrapped360(),
                                  .elevation = Angle::fromRadians(height)};
            const SkyPointing looked = beside(sun, 0.999 * std::sqrt(unit(random)) * kRadius, 6.3 * unit(random));
            if (sun.elevation < -2_deg || looked.elevation < 0_deg) {
                continue;
            }
            EXPECT_FALSE(region.permits(AxisPosition{looked.azimuth, looked.elevation})) << latitude;
            EXPECT_FALSE(
                region.permits(AxisPosition{(looked.azimuth + 180_deg).wrapped360(), 180_deg - looked.elevation}));
            EXPECT_FALSE(leant.permits(leaning.toAxes(looked).axes)) << latitude;
            ++seen;
        }
    }
    EXPECT_GT(seen, 8000);
}

// Not the whole sky is forbidden: at a middle northern latitude the part that the Sun never reaches stays permitted.
TEST(SunBand, LeavesFreeWhereTheSunNeverIs)
{
    const PermittedRegion region(withSun({}, sunBand(50_deg, 10_deg)), kSunKeepOutAzimuths, {0_deg, 90_deg});
    for (const AxisPosition& free :
         {AxisPosition{0_deg, 10_deg}, AxisPosition{320_deg, 20_deg}, AxisPosition{90_deg, 60_deg},
          AxisPosition{180_deg, 80_deg}, AxisPosition{180_deg, 2_deg}}) {
        EXPECT_TRUE(region.permits(free)) << free.azimuth.degrees() << ' ' << free.elevation.degrees();
    }
    EXPECT_FALSE(region.permits(AxisPosition{180_deg, 10_deg}));
    EXPECT_EQ(region.obstacle({180_deg, 40_deg}).toStdString(),
              "the keep-out \"Sun at any time: the clock is not synchronised\"");
}
