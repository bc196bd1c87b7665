// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_status.h"
#include "ui/polar_plot.h"
#include "ui/sky_limits.h"
#include "ui/theme.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

void expectNear(QPointF actual, QPointF expected, double tolerance)
{
    EXPECT_NEAR(actual.x(), expected.x(), tolerance);
    EXPECT_NEAR(actual.y(), expected.y(), tolerance);
}

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

class PlotTest : public ::testing::Test
{
protected:
    PlotTest() : plot(5_deg)
    {
        plot.resize(500, 520);
        plot.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&plot));
    }
    SkyMarkers& markers() { return *plot.findChild<SkyMarkers*>(); }
    QColor pixel(QPointF at) { return plot.grab().toImage().pixelColor(at.toPoint()); }
    PolarPlot plot;
};

// A wrong origin or direction of Qwt's azimuth scale would put the grid elsewhere than the markers.
TEST_F(PlotTest, QwtAndTheMarkersAgree)
{
    const SkyProjection& sky = plot.markers().projection();
    EXPECT_GT(sky.radius, 200.0);
    for (int azimuth = 0; azimuth < 360; azimuth += 15) {
        for (const int elevation : {0, 30, 60, 85}) {
            const SkyPointing there{Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation)};
            expectNear(plot.qwtPixel(there), sky.toPixel(there), 1e-6);
        }
    }
}

TEST_F(PlotTest, ActualIsPaintedWhereItPointsAndOnlyWhileItIsLive)
{
    applyTheme(ThemeKind::Day);
    StationStatus status = samples::tracking(100);
    const QPointF place = plot.markers().projection().toPixel(*status.actual);
    EXPECT_NE(pixel(place), currentTheme().text);
    plot.showStatus(status);
    EXPECT_EQ(pixel(place), currentTheme().text);
    plot.showStatus(samples::withAge(status, std::chrono::milliseconds(900)));
    EXPECT_NE(pixel(place), currentTheme().text);
    EXPECT_TRUE(plot.markers().markers().commanded.has_value());
    plot.showStatus(samples::withAge(status, std::chrono::milliseconds(2500)));
    EXPECT_FALSE(plot.markers().markers().commanded.has_value());
}

TEST_F(PlotTest, TheErrorLineAppearsAboveHalfABeamWidth)
{
    StationStatus status = samples::idle();
    status.actual = SkyPointing{359_deg, 45_deg};
    status.target = SkyPointing{1_deg, 45_deg};  // 1.41° apart
    plot.showStatus(status);
    EXPECT_FALSE(plot.markers().markers().offTarget);
    status.target = SkyPointing{4_deg, 45_deg};  // 3.5° apart
    plot.showStatus(status);
    EXPECT_TRUE(plot.markers().markers().offTarget);
}

TEST_F(PlotTest, TheTargetsLabelHidesNeitherTheMountNorItsCommand)
{
    StationStatus status = samples::idle();
    status.target = SkyPointing{80_deg, 20_deg};
    for (int east = 0; east < 120; east += 2) {
        for (int up = 0; up < 60; up += 2) {
            status.actual = SkyPointing{Angle::fromDegrees(30.0 + east), Angle::fromDegrees(up)};
            status.commanded = status.actual;
            plot.showStatus(status);
            const QRect label = plot.markers().targetLabelBox();
            ASSERT_FALSE(label.isEmpty());
            EXPECT_TRUE(plot.markers().rect().contains(label));
            EXPECT_FALSE(label.contains(plot.markers().projection().toPixel(*status.actual).toPoint()));
        }
    }
}

TEST_F(PlotTest, ThePastPathGrowsWithTheMotionAndNotWithOldData)
{
    for (int second = 0; second < 60; ++second) {
        plot.showStatus(samples::tracking(270.0 + second));
    }
    const std::size_t length = plot.markers().pathLength();
    EXPECT_GT(length, 30u);
    for (int i = 0; i < 20; ++i) {
        plot.showStatus(samples::tracking(329.0));
    }
    EXPECT_EQ(plot.markers().pathLength(), length);
    plot.showStatus(samples::withAge(samples::tracking(400.0), std::chrono::milliseconds(700)));
    EXPECT_EQ(plot.markers().pathLength(), length);
}

// A jump after silence is not a way the mount went.
TEST_F(PlotTest, ThePastPathHasAGapWhereTheMountWasNotSeen)
{
    for (const double second : {300.0, 301.0, 302.0, 60.0, 70.0, 80.0}) {
        plot.showStatus(samples::tracking(second));
    }
    int pieces = 0;
    const QPainterPath& path = plot.markers().pathPixels();
    for (int i = 0; i < path.elementCount(); ++i) {
        pieces += path.elementAt(i).isMoveTo() ? 1 : 0;
    }
    EXPECT_EQ(pieces, 2);
}

TEST_F(PlotTest, AClickReadsADirectionAndNothingOutsideTheCircle)
{
    SkyPointing clicked{};
    int clicks = 0;
    QObject::connect(&plot, &PolarPlot::clicked, &plot, [&](const SkyPointing& direction) {
        clicked = direction;
        ++clicks;
    });
    const QPointF east = plot.markers().projection().toPixel({90_deg, 45_deg});
    QTest::mouseClick(&markers(), Qt::LeftButton, {}, east.toPoint());
    EXPECT_EQ(clicks, 1);
    EXPECT_NEAR(clicked.azimuth.degrees(), 90.0, 0.5);
    EXPECT_NEAR(clicked.elevation.degrees(), 45.0, 0.5);
    QTest::mouseClick(&markers(), Qt::LeftButton, {}, QPoint(2, 2));
    EXPECT_EQ(clicks, 1);
}

TEST_F(PlotTest, IsDescribedInWords)
{
    StationStatus status = samples::operatorMoving();
    plot.describe(status);
    EXPECT_EQ(plot.accessibleDescription(),
              QStringLiteral("Actual az 62.0°  el 24.0°. Commanded az 64.5°  el 23.0°. Target az 113.0°  el 10.0°."));
    plot.describe(samples::withAge(status, std::chrono::milliseconds(900)));
    EXPECT_TRUE(plot.accessibleDescription().startsWith(QStringLiteral("Last seen at az 62.0°")));
}

TEST(SkyLimits, OnlyWhatTheAxesCannotReach)
{
    EXPECT_TRUE(unreachable({-90_deg, 450_deg}, {0_deg, 90_deg}).empty());
    EXPECT_TRUE(unreachable({}, {}).empty());

    const auto sectors = unreachable({-150_deg, 150_deg}, {10_deg, 85_deg});
    ASSERT_EQ(sectors.size(), 3u);
    EXPECT_EQ(sectors[0].toElevation, 10_deg);
    EXPECT_EQ(sectors[1].fromElevation, 85_deg);
    EXPECT_EQ(sectors[2].fromAzimuth, 150_deg);
    EXPECT_NEAR(sectors[2].toAzimuth.degrees(), 210.0, 1e-9);
}

TEST(SkyLimits, OverTheTopReachesAClosedSectorFromTheOtherSide)
{
    EXPECT_TRUE(unreachable({-150_deg, 150_deg}, {0_deg, 180_deg}).empty());
    const auto sectors = unreachable({-150_deg, 150_deg}, {0_deg, 150_deg});
    ASSERT_EQ(sectors.size(), 1u);
    EXPECT_NEAR(sectors[0].toElevation.degrees(), 30.0, 1e-9);
}

}  // namespace
}  // namespace boresight::ui
