// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/passes/pass_finder.h"
#include "tests/ui/event_loop.h"
#include "tests/ui/passes/passes_fixture.h"
#include "ui/passes/coast_points.h"
#include "ui/passes/ground_map.h"
#include "ui/passes/pass_curve.h"

#include <QToolButton>

#include <chrono>
#include <cmath>

namespace boresight::ui {
namespace {

using namespace std::chrono_literals;

const UtcTime kCurveBegin{std::chrono::sys_days{std::chrono::year{2026} / 3 / 1} + 5h};

// A pass of ten minutes that reaches 60° in the middle, and is hidden below 15° after that.
targets::SkyWay hill()
{
    auto way = std::make_shared<std::vector<targets::SkyMoment>>();
    for (int i = 0; i <= 40; ++i) {
        const double elevation = 60.0 * (1.0 - std::abs(i - 20) / 20.0);
        way->push_back({.utc = kCurveBegin + 15s * i,
                        .direction = {.azimuth = 90_deg, .elevation = Angle::fromDegrees(elevation)},
                        .isHidden = i > 35});
    }
    return way;
}

// REQ-PASSES-964: The curve of the selected pass goes from its rise to its set, is dotted where the limits hide it, and
// marks the present place of the satellite.
TEST(PassCurve, GoesFromRiseToSet)
{
    PassCurve curve;
    curve.resize(400, 200);
    EXPECT_TRUE(curve.line(false).isEmpty());
    curve.show(hill());
    const QRectF clear = curve.line(false).boundingRect();
    const QRectF hidden = curve.line(true).boundingRect();
    EXPECT_NEAR(clear.left(), curve.pixelOf(kCurveBegin, 0_deg).x(), 0.5);
    EXPECT_NEAR(clear.top(), curve.pixelOf(kCurveBegin, 60_deg).y(), 0.5);
    EXPECT_NEAR(hidden.right(), curve.pixelOf(kCurveBegin + 10min, 0_deg).x(), 0.5);
    EXPECT_NEAR(hidden.left(), clear.right(), 0.5);
    EXPECT_EQ(curve.top(), 90_deg);
    curve.setNow(kCurveBegin - 1s);
    EXPECT_FALSE(curve.place());
    curve.setNow(kCurveBegin + 150s);
    ASSERT_TRUE(curve.place());
    EXPECT_NEAR(curve.place()->y(), curve.pixelOf(kCurveBegin, 30_deg).y(), 0.5);
    curve.setNow(kCurveBegin + 10min + 1s);
    EXPECT_FALSE(curve.place());
}

TEST(PassCurve, ALowPassHasAScaleOfItsOwn)
{
    auto way = std::make_shared<std::vector<targets::SkyMoment>>(*hill());
    for (targets::SkyMoment& moment : *way) {
        moment.direction.elevation = 0.2 * moment.direction.elevation;
    }
    PassCurve curve;
    curve.show(way);
    EXPECT_EQ(curve.top(), 20_deg) << "12° high, with its number above the curve";
    for (targets::SkyMoment& moment : *way) {
        moment.direction.elevation = 0.2 * moment.direction.elevation;
    }
    curve.show(way);
    EXPECT_EQ(curve.top(), 10_deg);
}

TEST(GroundMap, ThePlacesAreWhereTheyAre)
{
    GroundMap map;
    map.resize(400, 200);
    EXPECT_EQ(map.pixelOf({.latitude = 0_deg, .longitude = 0_deg}), QPointF(200.0, 100.0));
    EXPECT_EQ(map.pixelOf({.latitude = 90_deg, .longitude = 90_deg}), QPointF(300.0, 0.0));
    map.resize(400, 100);
    EXPECT_EQ(map.pixelOf({.latitude = 0_deg, .longitude = -180_deg}), QPointF(100.0, 50.0)) << "in the middle";
}

// Story: a line from 179° to -179° was drawn across the whole map.
TEST(GroundMap, ALineIsBrokenWhereItLeavesTheMap)
{
    GroundMap map;
    map.resize(400, 200);
    const QPainterPath line = map.lineOf({{.latitude = 0_deg, .longitude = 170_deg},
                                          {.latitude = 0_deg, .longitude = 179_deg},
                                          {.latitude = 0_deg, .longitude = -179_deg},
                                          {.latitude = 0_deg, .longitude = -170_deg}});
    ASSERT_EQ(line.elementCount(), 4);
    EXPECT_TRUE(line.elementAt(2).isMoveTo());
    EXPECT_TRUE(line.elementAt(3).isLineTo());
}

// From 629 km a satellite sees a circle with a radius of 24.5°. Over a pole the circle goes around the pole.
TEST(GroundTrack, TheFootprintIsACircleOnTheEarth)
{
    const Site below{.latitude = 40_deg, .longitude = 175_deg, .heightMetres = 629'000.0};
    const double reach = std::acos(6371.0 / 7000.0);
    for (const Site& edge : footprintOf(below)) {
        const double cosine = std::sin(below.latitude.radians()) * std::sin(edge.latitude.radians()) +
                              std::cos(below.latitude.radians()) * std::cos(edge.latitude.radians()) *
                                  std::cos((edge.longitude - below.longitude).radians());
        EXPECT_NEAR(std::acos(cosine), reach, 1e-9);
        EXPECT_LE(std::abs(edge.longitude.degrees()), 180.0);
    }
    for (const Site& edge : footprintOf({.latitude = 90_deg, .heightMetres = 629'000.0})) {
        EXPECT_NEAR(edge.latitude.radians(), 90_deg / Angle::fromRadians(1.0) - reach, 1e-9);
    }
}

// The site is inside the circle of the satellite exactly while the satellite is up.
// REQ-PASSES-965: The map shows the path of the selected satellite over the Earth, during its pass and for one orbit
// more. It marks the site, the present place below the satellite, and the circle that sees the satellite.
TEST(GroundTrack, TheTrackOfAPassIsSeenFromTheSite)
{
    const Site site{.latitude = 38.757_deg, .longitude = -9.117_deg};
    PassBook book;
    book.site = site;
    book.satellites =
        std::make_shared<const std::vector<orbit::ElementSet>>(std::vector{fakes::lowOrbit(kCurveBegin, 10_deg)});
    const passes::PassList found = passes::findPasses(orbit::Sgp4(book.satellites->front()),
                                                      {.site = site, .from = kCurveBegin, .to = kCurveBegin + 24h});
    ASSERT_FALSE(found.passes.empty());
    const BookedPass pass{.pass = found.passes.front()};
    const GroundTrack track = groundTrackOf(pass, book);
    ASSERT_GT(track.pass.size(), 100U);
    ASSERT_GT(track.after.size(), 100U);
    EXPECT_EQ(track.pass.back(), track.after.front());
    for (const Site& below : track.pass) {
        const double cosine = std::sin(site.latitude.radians()) * std::sin(below.latitude.radians()) +
                              std::cos(site.latitude.radians()) * std::cos(below.latitude.radians()) *
                                  std::cos((site.longitude - below.longitude).radians());
        const double reach = std::acos(6371.0 / (6371.0 + below.heightMetres / 1000.0));
        EXPECT_LT(std::acos(cosine), reach + 0.01);
    }
    EXPECT_NEAR(track.after.back().latitude.degrees(), track.after.front().latitude.degrees(), 2.0) << "one turn";
}

// A simple check of the map: Lisbon is on land, the middle of the Atlantic is not.
TEST(Coast, LandIsLand)
{
    QPainterPath land;
    QPolygonF coast;
    for (const CoastPoint& point : coastPoints()) {
        if (point == kCoastEnd) {
            land.addPolygon(coast);
            land.closeSubpath();
            coast.clear();
        } else {
            EXPECT_LE(std::abs(point.longitude), 1800);
            EXPECT_LE(std::abs(point.latitude), 900);
            coast << QPointF(point.longitude / 10.0, point.latitude / 10.0);
        }
    }
    EXPECT_TRUE(coast.isEmpty()) << "the last line is closed";
    for (const QPointF& place :
         {QPointF(-8.0, 39.5), QPointF(13.4, 52.5), QPointF(-100.0, 40.0), QPointF(134.0, -25.0), QPointF(-55.0, -10.0),
          QPointF(25.0, 0.0), QPointF(100.0, 60.0), QPointF(0.0, -85.0)}) {
        EXPECT_TRUE(land.contains(place)) << place.x() << " " << place.y();
    }
    for (const QPointF& place : {QPointF(-40.0, 30.0), QPointF(-150.0, 0.0), QPointF(80.0, -20.0), QPointF(0.0, 85.0),
                                 QPointF(51.0, 42.0), QPointF(5.0, 39.0)}) {
        EXPECT_FALSE(land.contains(place)) << place.x() << " " << place.y();
    }
}

class PassPicturesTest : public PassesFixture
{};

TEST_F(PassPicturesTest, TheMapHasThePlaceOfTheSelectedSatelliteNow)
{
    StationStatus status = withSatellites();
    giveFound(status);
    QTest::mouseClick(named<QToolButton>("The path of the selected satellite over the Earth"), Qt::LeftButton);
    settle();
    const auto* const map = named<GroundMap>("Ground track of the satellite");
    ASSERT_TRUE(map->isVisible());
    ASSERT_TRUE(map->place());
    const Site before = *map->place();
    status.utc += 60s;
    give(samples::update(status));
    EXPECT_GT(std::abs((map->place()->longitude - before.longitude).wrapped180().degrees()), 1.0);
    EXPECT_NEAR(map->place()->heightMetres, 420'000.0, 60'000.0);
}

}  // namespace
}  // namespace boresight::ui
