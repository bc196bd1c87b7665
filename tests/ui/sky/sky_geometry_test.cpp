// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sky/expect_near.h"
#include "ui/sky/sky_limits.h"
#include "ui/sky/sky_projection.h"
#include "ui/sky/sky_zoom.h"

#include <QLineF>
#include <QPainterPath>

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

// REQ-UI-08 (SkyProjection.*): The plot has north up and east right. Qwt's grid agrees with the markers.
TEST(SkyProjection, NorthIsUpAndEastIsRight)
{
    const SkyProjection sky{QPointF(100, 100), 90.0};
    expectNear(sky.toPixel({0_deg, 0_deg}), {100, 10}, 1e-9);
    expectNear(sky.toPixel({90_deg, 0_deg}), {190, 100}, 1e-9);
    expectNear(sky.toPixel({180_deg, 30_deg}), {100, 160}, 1e-9);
    expectNear(sky.toPixel({270_deg, 60_deg}), {70, 100}, 1e-9);
    expectNear(sky.toPixel({123_deg, 90_deg}), {100, 100}, 1e-9);
}

TEST(SkyProjection, FlippedLiesAtItsSkyPlaceAndBelowTheHorizonOnTheRim)
{
    const SkyProjection sky{QPointF(100, 100), 90.0};
    expectNear(sky.toPixel({0_deg, 120_deg}), sky.toPixel({180_deg, 60_deg}), 1e-9);
    expectNear(sky.toPixel({90_deg, -5_deg}), {190, 100}, 1e-9);
}

TEST(SkyProjection, PixelAndSkyRoundTrip)
{
    const SkyProjection sky{QPointF(240.5, 250.5), 210.0};
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 7.5) {
        for (double elevation = 0.0; elevation < 90.0; elevation += 7.5) {
            const SkyPointing there{Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation)};
            const SkyPointing back = sky.toSky(sky.toPixel(there));
            EXPECT_NEAR((back.azimuth - there.azimuth).wrapped180().degrees(), 0.0, 1e-6);
            EXPECT_NEAR(back.elevation.degrees(), elevation, 1e-6);
        }
    }
}

// Story: the rim cut "X -88°" to "88°", which is the other limit.
// REQ-UI-1755: The name of a limit or of a keep-out is completely inside the rim.
TEST(SkyProjection, ANameIsMovedInsideTheRim)
{
    const SkyProjection sky{QPointF(300, 300), 295.0};
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 7.5) {
        QRectF box(0.0, 0.0, 46.0, 15.0);
        box.moveCenter(sky.toPixel({Angle::fromDegrees(azimuth), 1_deg}));
        EXPECT_FALSE(sky.contains(box)) << azimuth;
        const QRectF moved = sky.inside(box);
        EXPECT_TRUE(sky.contains(moved)) << azimuth;
        EXPECT_EQ(moved.size(), box.size());
        EXPECT_LE(QLineF(moved.center(), box.center()).length(), 46.0) << "no further than it must";
        EXPECT_EQ(sky.inside(moved), moved);
    }
}

// REQ-UI-20 (SkyLimits.*)
TEST(SkyLimits, OnlyWhatTheAxesCannotReach)
{
    EXPECT_TRUE(unreachable({{-90_deg, 450_deg}, {0_deg, 90_deg}}).empty());
    EXPECT_TRUE(unreachable({}).empty());

    const auto sectors = unreachable({{-150_deg, 150_deg}, {10_deg, 85_deg}});
    ASSERT_EQ(sectors.size(), 3u);
    EXPECT_EQ(sectors[0].toElevation, 10_deg);
    EXPECT_EQ(sectors[1].fromElevation, 85_deg);
    EXPECT_EQ(sectors[2].fromAzimuth, 150_deg);
    EXPECT_NEAR(sectors[2].toAzimuth.degrees(), 210.0, 1e-9);
}

// The limits of X cut off the east and the west, those of Y the north and the south.
// REQ-UI-1751: The sky shows the limits of X and Y of an X/Y mount as the curves that they are there.
TEST(SkyLimits, TheLimitsOfXAndYAreCurves)
{
    const SkyProjection sky{QPointF(100, 100), 90.0};
    const pointing::PointingModel xy(pointing::PointingTerms{.geometry = {.kind = pointing::Geometry::XY}});
    EXPECT_TRUE(unreachable({{-90_deg, 90_deg}, {-90_deg, 90_deg}, xy}).empty());
    const auto sectors = unreachable({{-60_deg, 70_deg}, {-90_deg, 80_deg}, xy});
    ASSERT_EQ(sectors.size(), 3u);
    EXPECT_EQ(sectors[0].name, QStringLiteral("X -60°"));
    EXPECT_EQ(sectors[1].name, QStringLiteral("X 70°"));
    EXPECT_EQ(sectors[2].name, QStringLiteral("Y 80°"));
    for (double azimuth = 1.0; azimuth < 360.0; azimuth += 7.0) {
        for (double elevation = 1.0; elevation < 90.0; elevation += 3.0) {
            const SkyPointing beam{Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation)};
            const AxisPosition axes = xy.toAxes(beam).axes;
            const auto isNear = [](Angle angle, Angle limit) { return abs(angle - limit) < 1_deg; };
            if (isNear(axes.azimuth, -60_deg) || isNear(axes.azimuth, 70_deg) || isNear(axes.elevation, 80_deg)) {
                continue;
            }
            const QPointF pixel = sky.toPixel(beam);
            EXPECT_EQ(outline(sectors[0], sky).contains(pixel), axes.azimuth < -60_deg) << azimuth << ' ' << elevation;
            EXPECT_EQ(outline(sectors[1], sky).contains(pixel), axes.azimuth > 70_deg) << azimuth << ' ' << elevation;
            EXPECT_EQ(outline(sectors[2], sky).contains(pixel), axes.elevation > 80_deg) << azimuth << ' ' << elevation;
        }
    }
}

TEST(SkyLimits, OverTheTopReachesAClosedSectorFromTheOtherSide)
{
    EXPECT_TRUE(unreachable({{-150_deg, 150_deg}, {0_deg, 180_deg}}).empty());
    const auto sectors = unreachable({{-150_deg, 150_deg}, {0_deg, 150_deg}});
    ASSERT_EQ(sectors.size(), 1u);
    EXPECT_NEAR(sectors[0].toElevation.degrees(), 30.0, 1e-9);
}

TEST(SkyLimits, TheLimitsCountAsFarAsTheTravelGoes)
{
    pointing::Region region;
    const Travel travel{{-90_deg, 450_deg}, {0_deg, 90_deg}};
    EXPECT_EQ(permitted(region, travel), travel);
    EXPECT_TRUE(sectorsOf(region, travel).empty());
    region.azimuth = {-30_deg, 200_deg};
    region.elevation.min = 8_deg;
    region.keepOuts = {{"mast", 350_deg, 10_deg, 0_deg, 40_deg}};
    const auto sectors = sectorsOf(region, travel);
    ASSERT_EQ(sectors.size(), 3u);
    EXPECT_EQ(sectors[0].kind, SectorKind::Band);
    EXPECT_EQ(sectors[1].fromAzimuth, 200_deg);
    EXPECT_NEAR(sectors[1].toAzimuth.degrees(), 330.0, 1e-9);
    EXPECT_EQ(sectors[2].name, QStringLiteral("mast"));
    EXPECT_NEAR(sectors[2].toAzimuth.degrees(), 370.0, 1e-9);
}

TEST(SkyLimits, TheHorizonIsClosedThroughNorth)
{
    const SkyProjection sky{QPointF(250, 250), 225.0};
    const QPainterPath line = horizonLine({{90_deg, 20_deg}, {270_deg, 40_deg}}, sky);
    EXPECT_TRUE(horizonLine({}, sky).isEmpty());
    // Halfway between the points, on both sides: 30°. The area inside the line is the sky above the horizon.
    for (const Angle azimuth : {0_deg, 180_deg}) {
        EXPECT_TRUE(line.contains(sky.toPixel({azimuth, 30.5_deg})));
        EXPECT_FALSE(line.contains(sky.toPixel({azimuth, 29.5_deg})));
    }
    EXPECT_TRUE(line.contains(sky.toPixel({90_deg, 20.5_deg})));
    EXPECT_FALSE(line.contains(sky.toPixel({270_deg, 39.5_deg})));
}

// REQ-UI-23 (SkyZoom.*)
TEST(SkyZoom, TheGridIsFineEnoughAndOnlyWhereItIsSeen)
{
    SkyZoom zoom;
    zoom.centreOn({350_deg, 20_deg});
    zoom.toggle(0.5_deg);
    const QRectF view(0, 0, 500, 500);
    const SkyGrid grid = gridOf(zoom.projection({view.center(), 230.0}), view);
    ASSERT_GE(grid.elevations.size(), 3u);
    EXPECT_LE(grid.elevations.size(), 12u);
    EXPECT_NEAR(grid.elevations.front(), 20.0, 5.0);
    ASSERT_GE(grid.azimuths.size(), 3u);
    EXPECT_LE(grid.azimuths.size(), 12u);
    for (const double azimuth : grid.azimuths) {
        EXPECT_NEAR(azimuth, 350.0, 6.0);
    }
}

}  // namespace
}  // namespace boresight::ui
