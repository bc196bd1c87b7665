// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/sun_keep_out.h"
#include "tests/ui/event_loop.h"
#include "tests/ui/sample_status.h"
#include "tests/ui/sky/expect_near.h"
#include "ui/kit/theme.h"
#include "ui/kit/value_label.h"
#include "ui/sky/plot_tools.h"
#include "ui/sky/polar_plot.h"

#include <QApplication>
#include <QPainter>
#include <QSignalSpy>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

// The plain colour of the sky at this elevation, in any theme. The picture has rounding errors.
bool isSky(const QColor& colour, Angle elevation)
{
    const double part = 1.0 - elevation / 90_deg;
    const QColor zenith = currentTheme().skyZenith;
    const QColor rim = currentTheme().skyRim;
    const auto near = [part](int is, int atZenith, int atRim) {
        return std::abs(is - (atZenith + part * (atRim - atZenith))) <= 2.0;
    };
    return near(colour.red(), zenith.red(), rim.red()) && near(colour.green(), zenith.green(), rim.green()) &&
           near(colour.blue(), zenith.blue(), rim.blue());
}

class PlotTest : public ::testing::Test
{
protected:
    PlotTest() : draft(desk), plot(draft, desk)
    {
        plot.resize(500, 520);
        plot.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&plot, kPatienceMs));
    }
    SkyMarkers& markers() { return *plot.findChild<SkyMarkers*>(); }
    QColor pixel(QPointF at) { return plot.grab().toImage().pixelColor(at.toPoint()); }
    // True if nothing is drawn at this direction or next to it.
    bool isFree(const SkyPointing& direction)
    {
        const QImage image = plot.grab().toImage();
        const QPoint at = markers().projection().toPixel(direction).toPoint();
        bool free = true;
        for (const QPoint& beside : {QPoint(0, 0), QPoint(-1, 0), QPoint(1, 0), QPoint(0, -1), QPoint(0, 1)}) {
            free = free && isSky(image.pixelColor(at + beside), direction.elevation);
        }
        return free;
    }
    RequestDesk desk;
    ProfileDraft draft;
    PolarPlot plot;
};

// A wrong origin or direction of Qwt's azimuth scale would draw the grid at another place than the markers.
// REQ-UI-08
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

// REQ-UI-04
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

// Story: for a mount with an azimuth only, the plot showed the antenna at the horizon. A keep-out for all elevations
// was drawn as a part of them.
// REQ-MOUNT-14: The plot shows the beam of a mount with one axis as a line of all its possible places. Forbidden areas
// are drawn as they apply, and no text contains the missing angle.
TEST_F(PlotTest, TheBeamOfAMountWithOneAxisIsALine)
{
    applyTheme(ThemeKind::Day);
    StationStatus status = samples::idle();
    profile::Profile profile = *status.profile;
    profile.limits = {.horizon = {{.azimuth = 0_deg, .elevation = 25_deg}},
                      .keepOuts = {{.name = "mast",
                                    .azimuthFrom = 80_deg,
                                    .azimuthTo = 100_deg,
                                    .elevationMin = 20_deg,
                                    .elevationMax = 40_deg}}};
    status.profile = std::make_shared<const profile::Profile>(profile);
    status.actual = SkyPointing{200_deg, 0_deg};
    status.target = SkyPointing{200_deg, 0_deg};
    plot.showStatus(status);
    const SkyPointing beam{200_deg, 50_deg};
    const SkyPointing aboveMast{85_deg, 70_deg};
    const SkyPointing low{230_deg, 15_deg};
    EXPECT_TRUE(isFree(beam));
    EXPECT_TRUE(isFree(aboveMast));
    EXPECT_FALSE(isFree(low)) << "below the horizon";
    status.capabilities.axes[index(Axis::Elevation)].reset();
    status.elevation.state = AxisState::Missing;
    status.elevation.travel = {};
    plot.showStatus(status);
    EXPECT_FALSE(isFree(beam));
    EXPECT_FALSE(isFree(aboveMast));
    EXPECT_TRUE(isFree(low));
    EXPECT_EQ(plot.markers().markers().targetLabel, QStringLiteral("AZ 200.0°"));
    plot.describe(status);
    EXPECT_TRUE(plot.accessibleDescription().contains(QStringLiteral("Target AZ 200.0°.")));
    status.capabilities = {};
    status.capabilities.axes[index(Axis::Azimuth)].reset();
    status.elevation.travel = {.min = 0_deg, .max = 90_deg};
    status.azimuth.travel = {};
    status.actual = SkyPointing{0_deg, 50_deg};
    plot.showStatus(status);
    EXPECT_FALSE(isFree(beam)) << "all around";
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

// Story: the label of a target beside a keep-out was drawn on the name of the keep-out, and nobody could read either.
TEST_F(PlotTest, TheTargetsLabelSparesTheNameOfAKeepOut)
{
    StationStatus status = samples::idle();
    auto profile = std::make_shared<profile::Profile>(*status.profile);
    profile->limits.keepOuts = {
        {.name = "mast", .azimuthFrom = 300_deg, .azimuthTo = 330_deg, .elevationMin = 20_deg, .elevationMax = 50_deg}};
    status.profile = profile;
    plot.showStatus(status);
    QCoreApplication::processEvents();
    // Where the name is drawn.
    const QPoint name = plot.markers().projection().toPixel({315_deg, 35_deg}).toPoint();
    for (int degrees = 280; degrees < 350; degrees += 2) {
        for (int up = 10; up < 60; up += 2) {
            status.target = SkyPointing{Angle::fromDegrees(degrees), Angle::fromDegrees(up)};
            plot.showStatus(status);
            EXPECT_FALSE(plot.markers().targetLabelBox().contains(name)) << degrees << ' ' << up;
        }
    }
}

// Story: the label of a target at the horizon was drawn on the cable ring, and hid the degrees beside it.
TEST_F(PlotTest, TheTargetsLabelStaysInsideTheRim)
{
    StationStatus status = samples::idle();
    status.actual = SkyPointing{10_deg, 80_deg};
    status.commanded = status.actual;
    for (int degrees = 0; degrees < 360; degrees += 3) {
        for (int up = 0; up < 30; up += 3) {
            status.target = SkyPointing{Angle::fromDegrees(degrees), Angle::fromDegrees(up)};
            plot.showStatus(status);
            const QRectF label = plot.markers().targetLabelBox();  // in whole pixels
            EXPECT_TRUE(plot.markers().projection().contains(label.adjusted(1, 1, -1, -1))) << degrees << ' ' << up;
        }
    }
}

TEST_F(PlotTest, ThePastPathGrowsWithTheMotionAndNotWithOldData)
{
    for (int second = 0; second < 60; ++second) {
        plot.showStatus(samples::tracking(270.0 + second));
    }
    const std::size_t length = plot.markers().trail().length();
    EXPECT_GT(length, 30u);
    for (int i = 0; i < 20; ++i) {
        plot.showStatus(samples::tracking(329.0));
    }
    EXPECT_EQ(plot.markers().trail().length(), length);
    plot.showStatus(samples::withAge(samples::tracking(400.0), std::chrono::milliseconds(700)));
    EXPECT_EQ(plot.markers().trail().length(), length);
}

// A jump after silence is not a part of the path.
TEST_F(PlotTest, ThePastPathHasAGapWhereTheMountWasNotSeen)
{
    for (const double second : {300.0, 301.0, 302.0, 60.0, 70.0, 80.0}) {
        plot.showStatus(samples::tracking(second));
    }
    int pieces = 0;
    const QPainterPath& path = plot.markers().trail().pixels();
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
              QStringLiteral("Actual az 62.0°  el 24.0°. Commanded az 64.5°  el 23.0°. Target az 113.0°  el 10.0°. "
                             "The azimuth cable is at 62°. Its travel is from -90° to 450°. The nearer end is 152° "
                             "away."));
    status.sensor.direction = SkyPointing{61_deg, 24_deg};
    plot.describe(status);
    EXPECT_TRUE(plot.accessibleDescription().contains(QStringLiteral("Sensor az 61.0°  el 24.0°.")));
    plot.describe(samples::withAge(status, std::chrono::milliseconds(900)));
    EXPECT_TRUE(plot.accessibleDescription().startsWith(QStringLiteral("Last seen at az 62.0°")));
}

// REQ-UI-20: The plot draws the region of the profile in effect, again only when it changes. Edits are dashed until
// applied.
TEST_F(PlotTest, TheRegionInForceIsDrawnAndItsNewOneWithTheNextStatus)
{
    applyTheme(ThemeKind::Day);
    StationStatus status = samples::bounded();
    plot.showStatus(status);
    const auto shade = [this](Angle azimuth, Angle elevation) {
        return pixel(plot.markers().projection().toPixel({azimuth, elevation}));
    };
    EXPECT_EQ(shade(170_deg, 15_deg), currentTheme().land) << "below the hill";
    EXPECT_TRUE(isSky(shade(170_deg, 40_deg), 40_deg));
    profile::Profile changed = *status.profile;
    changed.limits.horizon.clear();
    status.profile = std::make_shared<const profile::Profile>(changed);
    plot.showStatus(status);
    EXPECT_TRUE(isSky(shade(170_deg, 15_deg), 15_deg));
}

TEST_F(PlotTest, TheSunIsDrawnWhileTheBeamIsKeptAwayFromIt)
{
    applyTheme(ThemeKind::Day);
    StationStatus status = samples::bounded();
    plot.showStatus(status);
    const auto shade = [this](Angle azimuth, Angle elevation) {
        return pixel(plot.markers().projection().toPixel({azimuth, elevation}));
    };
    const auto isShaded = [&](const SkyPointing& middle) {  // hatched, so several pixels are checked
        for (const Angle beside : {0_deg, 0.7_deg, 1.4_deg}) {
            if (!isSky(shade(middle.azimuth + beside, middle.elevation + beside), middle.elevation + beside)) {
                return true;
            }
        }
        return false;
    };
    ASSERT_FALSE(isShaded({.azimuth = 220_deg, .elevation = 55_deg}));
    status.sunKeepOuts = {*pointing::sunKeepOut({.azimuth = 220_deg, .elevation = 55_deg}, 15_deg)};
    plot.showStatus(status);
    EXPECT_TRUE(isShaded({.azimuth = 220_deg, .elevation = 55_deg}));
    status.sunKeepOuts = {*pointing::sunKeepOut({.azimuth = 220_deg, .elevation = 80_deg}, 15_deg)};
    plot.showStatus(status);
    EXPECT_TRUE(isShaded({.azimuth = 40_deg, .elevation = 70_deg})) << "all round the zenith";
    status.sunKeepOuts.clear();
    plot.showStatus(status);
    EXPECT_FALSE(isShaded({.azimuth = 220_deg, .elevation = 55_deg}));
}

// REQ-UI-20
TEST_F(PlotTest, TheGroundIsDrawnAgainOnlyWhenSomethingOfItChanged)
{
    plot.showStatus(samples::bounded());
    const qint64 ground = plot.markers().ground().cacheKey();
    plot.showStatus(samples::routed());  // the same profile: only markers move
    EXPECT_EQ(plot.markers().ground().cacheKey(), ground);
}

TEST_F(PlotTest, TheWayAheadFollowsTheRouteAroundTheKeepOut)
{
    plot.showStatus(samples::bounded());
    EXPECT_TRUE(plot.markers().wayPixels().isEmpty());
    plot.showStatus(samples::routed());
    const SkyProjection& sky = plot.markers().projection();
    const QPainterPath& way = plot.markers().wayPixels();
    expectNear(way.elementAt(0), sky.toPixel({33_deg, 22_deg}), 1e-6);
    expectNear(way.currentPosition(), sky.toPixel({100_deg, 20_deg}), 1e-6);
    bool overTheMast = false;
    for (int i = 0; i < way.elementCount(); ++i) {
        overTheMast = overTheMast || (sky.toPixel({68_deg, 48_deg}) - QPointF(way.elementAt(i))).manhattanLength() < 3;
    }
    EXPECT_TRUE(overTheMast);
    plot.showStatus(samples::withAge(samples::routed(), std::chrono::milliseconds(2500)));
    EXPECT_TRUE(plot.markers().wayPixels().isEmpty()) << "where the set-point is, nobody knows";
}

TEST_F(PlotTest, ThePastPathIsAQuarterOfAnHourLong)
{
    StationStatus status = samples::bounded();
    for (int minute = 0; minute < 40; ++minute) {
        status.actual = SkyPointing{Angle::fromDegrees(20.0 + minute), 45_deg};
        status.utc += std::chrono::minutes(1);
        plot.showStatus(status);
    }
    EXPECT_GE(plot.markers().trail().length(), 15u);
    EXPECT_LE(plot.markers().trail().length(), 17u);
}

// REQ-UI-23: The magnified plot has a frame and a scale, and moves only when the target leaves its inner half.
TEST_F(PlotTest, ZoomMagnifiesAroundTheTargetAndSaysSo)
{
    applyTheme(ThemeKind::Day);
    StationStatus status = samples::bounded();
    plot.showStatus(status);
    const QPointF middle = QRectF(plot.rect()).center();
    plot.toggleZoom();
    EXPECT_TRUE(plot.zoom().isOn());
    EXPECT_EQ(plot.zoom().halfView(), 25_deg);  // five beam widths of 5°
    const SkyProjection& sky = plot.markers().projection();
    expectNear(sky.toPixel(*status.target), middle, 1e-6);
    for (const SkyPointing there : {SkyPointing{20_deg, 45_deg}, SkyPointing{300_deg, 60_deg}}) {
        expectNear(plot.qwtPixel(there), sky.toPixel(there), 1e-6);
    }
    EXPECT_EQ(pixel(QPointF(1, plot.height() / 2.0)), currentTheme().accent) << "framed";
    plot.toggleZoom();
    EXPECT_FALSE(plot.zoom().isOn());
}

// REQ-UI-23
TEST_F(PlotTest, TheMagnifiedViewFollowsInStepsOnly)
{
    StationStatus status = samples::bounded();
    plot.showStatus(status);
    plot.toggleZoom();
    const SkyProjection before = plot.markers().projection();
    status.target = SkyPointing{22_deg, 46_deg};
    plot.showStatus(status);
    EXPECT_EQ(plot.markers().projection(), before);
    status.target = SkyPointing{20_deg, 70_deg};
    plot.showStatus(status);
    EXPECT_NE(plot.markers().projection(), before);
    expectNear(plot.markers().projection().toPixel(*status.target), QRectF(plot.rect()).center(), 1e-6);
}

TEST_F(PlotTest, TheWheelMagnifiesAndComesBackToTheWholeSky)
{
    plot.showStatus(samples::bounded());
    const auto turn = [this](int notches) {
        const QPointF at = QRectF(plot.rect()).center();
        QWheelEvent event(at, plot.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&plot, &event);
    };
    turn(4);
    EXPECT_NEAR(plot.zoom().magnification(), std::pow(1.25, 4), 1e-9);
    turn(100);
    EXPECT_NEAR(plot.zoom().magnification(), 18.0, 1e-9);  // one beam width from the middle to the edge
    turn(-100);
    EXPECT_FALSE(plot.zoom().isOn());
}

TEST_F(PlotTest, IsSavedAsPngAndSvg)
{
    QTemporaryDir folder;
    plot.showStatus(samples::routed());
    plot.tools().save(folder.filePath(QStringLiteral("sky.png")));
    const QImage png(folder.filePath(QStringLiteral("sky.png")));
    EXPECT_EQ(png.size(), plot.size() * 2);
    plot.tools().save(folder.filePath(QStringLiteral("sky.svg")));
    QSvgRenderer svg(folder.filePath(QStringLiteral("sky.svg")));
    ASSERT_TRUE(svg.isValid());
    EXPECT_EQ(svg.viewBox().size(), plot.size());
    QImage drawn(plot.size(), QImage::Format_RGB32);
    drawn.fill(Qt::black);
    QPainter painter(&drawn);
    svg.render(&painter);
    painter.end();
    const QPoint sky = plot.markers().projection().toPixel({345_deg, 50_deg}).toPoint();
    EXPECT_TRUE(isSky(drawn.pixelColor(sky), 50_deg));
    EXPECT_TRUE(isSky(png.pixelColor(sky * 2), 50_deg));
}

TEST_F(PlotTest, AFileThatCannotBeWrittenIsSaid)
{
    plot.tools().save(QStringLiteral("/nowhere/sky.png"));
    bool said = false;
    for (const ValueLabel* const label : plot.findChildren<ValueLabel*>()) {
        said = said || label->text().startsWith(QStringLiteral("Not saved"));
    }
    EXPECT_TRUE(said);
}

}  // namespace
}  // namespace boresight::ui
