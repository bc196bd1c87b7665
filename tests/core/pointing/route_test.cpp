// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/route.h"

#include "core/pointing/nearest_permitted.h"
#include "tests/core/pointing/at.h"
#include "tests/fakes/random_region.h"
#include "tests/fakes/text_of.h"

#include <queue>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace boresight;
using namespace boresight::pointing;

namespace {

constexpr TravelRange kRouteAzimuths{-200_deg, 460_deg};
constexpr AxisRates kSpeed{.azimuth = 10_deg_s, .elevation = 8_deg_s};

KeepOut routeMast(Angle top = 40_deg)
{
    return {
        .name = "routeMast", .azimuthFrom = 300_deg, .azimuthTo = 330_deg, .elevationMin = 0_deg, .elevationMax = top};
}

double duration(AxisPosition from, const std::vector<AxisPosition>& way)
{
    double seconds = 0.0;
    for (const AxisPosition& place : way) {
        seconds += std::max(abs(place.azimuth - from.azimuth) / kSpeed.azimuth.degrees() / 1_deg,
                            abs(place.elevation - from.elevation) / kSpeed.elevation.degrees() / 1_deg);
        from = place;
    }
    return seconds;
}

void expectPermitted(const PermittedRegion& region, AxisPosition from, const std::vector<AxisPosition>& way)
{
    for (const AxisPosition& place : way) {
        EXPECT_TRUE(region.permits(AxisBox::between(from, place)));
        from = place;
    }
}

// The cells of a grid that can be reached from `from`, going from one whole cell to the next.
class Flood
{
public:
    Flood(const PermittedRegion& region, double cell) : m_cell(cell), m_ranges(region.ranges())
    {
        m_columns = count(m_ranges.azimuth);
        m_rows = count(m_ranges.elevation);
        for (int i = 0; i < m_columns * m_rows; ++i) {
            m_free.push_back(region.permits(boxOf(i)));
        }
    }

    bool connects(const AxisPosition& from, const AxisPosition& to)
    {
        const int start = cellAt(from);
        const int end = cellAt(to);
        if (!m_free[size(start)] || !m_free[size(end)]) {
            return false;
        }
        std::vector<bool> seen(m_free.size());
        std::queue<int> open;
        open.push(start);
        seen[size(start)] = true;
        while (!open.empty()) {
            const int here = open.front();
            open.pop();
            if (here == end) {
                return true;
            }
            const int column = here % m_columns;
            visit(here - 1, column > 0, seen, open);
            visit(here + 1, column + 1 < m_columns, seen, open);
            visit(here - m_columns, here >= m_columns, seen, open);
            visit(here + m_columns, here + m_columns < m_columns * m_rows, seen, open);
        }
        return false;
    }

private:
    static std::size_t size(int index) { return static_cast<std::size_t>(index); }
    int count(const TravelRange& range) const
    {
        return std::max(1, static_cast<int>((range.max - range.min).degrees() / m_cell));
    }
    int cellAt(const AxisPosition& place) const
    {
        const int column = static_cast<int>((place.azimuth - m_ranges.azimuth.min).degrees() / m_cell);
        const int row = static_cast<int>((place.elevation - m_ranges.elevation.min).degrees() / m_cell);
        return std::clamp(row, 0, m_rows - 1) * m_columns + std::clamp(column, 0, m_columns - 1);
    }
    AxisBox boxOf(int index) const
    {
        const Angle side = Angle::fromDegrees(m_cell);
        const Angle azimuth = m_ranges.azimuth.min + side * (index % m_columns);
        const Angle elevation = m_ranges.elevation.min + side * (index / m_columns);
        return {.azimuth = {azimuth, azimuth + side}, .elevation = {elevation, elevation + side}};
    }
    void visit(int cell, bool exists, std::vector<bool>& seen, std::queue<int>& open) const
    {
        if (exists && m_free[size(cell)] && !seen[size(cell)]) {
            seen[size(cell)] = true;
            open.push(cell);
        }
    }

    double m_cell;
    AxisBox m_ranges;
    int m_columns = 0;
    int m_rows = 0;
    std::vector<bool> m_free;
};

}  // namespace

TEST(Route, IsDirectWhereTheWayIsFree)
{
    const PermittedRegion region({.keepOuts = {routeMast()}}, kRouteAzimuths, {0_deg, 90_deg});
    EXPECT_EQ(*route(region, at(100, 10), at(290, 80), kSpeed), std::vector{at(290, 80)});
    EXPECT_EQ(*route(region, at(290, 40), at(340, 60), kSpeed), std::vector{at(340, 60)});
    EXPECT_EQ(*route(region, at(290, 10), at(290, 10), kSpeed), std::vector{at(290, 10)});
}

TEST(Route, GoesOverAKeepOut)
{
    const PermittedRegion region({.keepOuts = {routeMast()}}, kRouteAzimuths, {0_deg, 90_deg});
    const auto way = route(region, at(290, 10), at(340, 5), kSpeed);
    ASSERT_TRUE(way);
    EXPECT_EQ(*way, (std::vector{at(300, 40), at(330, 40), at(340, 5)}));
}

TEST(Route, ClimbsOverTheHorizonOnTheWay)
{
    const PermittedRegion region({.horizon = {{0_deg, 0_deg}, {100_deg, 10_deg}, {120_deg, 30_deg}, {140_deg, 0_deg}}},
                                 kRouteAzimuths, {0_deg, 90_deg});
    const auto way = route(region, at(50, 12), at(150, 5), kSpeed);
    ASSERT_TRUE(way);
    ASSERT_EQ(way->size(), 3U);
    EXPECT_NEAR((*way)[0].azimuth.degrees(), 102, 1e-6);  // as far as the azimuth can go at 12°
    EXPECT_NEAR((*way)[0].elevation.degrees(), 30, 1e-6);
    EXPECT_NEAR((*way)[1].elevation.degrees(), 30, 1e-6);
    expectPermitted(region, at(50, 12), *way);
}

TEST(Route, PassesBelowWhatHangsInTheSky)
{
    const KeepOut wires{"wires", 80_deg, 120_deg, 20_deg, 85_deg};
    const PermittedRegion region({.keepOuts = {wires}}, kRouteAzimuths, {0_deg, 90_deg});
    const auto way = route(region, at(70, 30), at(130, 30), kSpeed);
    ASSERT_TRUE(way);
    EXPECT_EQ(*way, (std::vector{at(80, 20), at(120, 20), at(130, 30)}));
}

// REQ-POINTING-16: Where there is no route, the obstacle is named.
TEST(Route, SaysWhatIsInTheWayWhenThereIsNone)
{
    const PermittedRegion wall({.keepOuts = {routeMast(90_deg)}}, {0_deg, 360_deg}, {0_deg, 90_deg});
    const auto way = route(wall, at(290, 10), at(340, 5), kSpeed);
    ASSERT_FALSE(way);
    EXPECT_EQ(textOf(way.error()),
              "There is no way from 290.0° 10.0° to 340.0° 5.0°. Between them is the keep-out \"routeMast\".");
    const auto inside = route(wall, at(290, 10), at(315, 10), kSpeed);
    ASSERT_FALSE(inside);
    EXPECT_EQ(textOf(inside.error()), "315.0° / 10.0° lies in keep-out \"routeMast\"");
}

TEST(Route, LeadsOutOfAForbiddenPlaceFirst)
{
    const PermittedRegion region({.keepOuts = {routeMast()}}, kRouteAzimuths, {0_deg, 90_deg});
    const auto way = route(region, at(310, 38), at(340, 5), kSpeed);
    ASSERT_TRUE(way);
    ASSERT_EQ(way->size(), 3U);
    EXPECT_EQ((*way)[0], at(310, 40));
    EXPECT_EQ((*way)[1], at(330, 40));
}

// Every leg is permitted. Where no route is found, the grid has none either. No route is longer than the one over the
// top of all obstacles.
// REQ-POINTING-15: A route exists wherever a grid finds one. Each leg is permitted as a box, and no route is a detour.
TEST(Route, FindsAWayWhereThereIsOne)
{
    std::mt19937 random(3);
    fakes::RandomRegion make(random);
    int direct = 0;
    int bent = 0;
    int none = 0;
    for (int round = 0; round < 250; ++round) {
        const PermittedRegion region{make.region(), make.azimuthTravel(), make.elevationTravel()};
        if (region.ranges().azimuth.max - region.ranges().azimuth.min < 10_deg) {
            continue;
        }
        Flood flood(region, 2.0);
        for (int i = 0; i < 20; ++i) {
            const AxisPosition from = make.place(region.ranges().azimuth, region.ranges().elevation);
            const AxisPosition to = make.place(region.ranges().azimuth, region.ranges().elevation);
            if (!region.permits(from) || !region.permits(to)) {
                continue;
            }
            const auto way = route(region, from, to, kSpeed);
            if (!way) {
                EXPECT_FALSE(flood.connects(from, to)) << textOf(way.error());
                ++none;
                continue;
            }
            expectPermitted(region, from, *way);
            EXPECT_EQ(way->back(), to);
            ++(way->size() == 1 ? direct : bent);
        }
    }
    EXPECT_GT(direct, 100);
    EXPECT_GT(bent, 100);
    EXPECT_GT(none, 5);
}

// Where a route over the top of the obstacle exists, the chosen route takes no longer.
// REQ-POINTING-15
TEST(Route, IsNoDetour)
{
    std::mt19937 random(5);
    fakes::RandomRegion make(random);
    int checked = 0;
    for (int round = 0; round < 300; ++round) {
        Region drawn = make.region();
        drawn.azimuth = drawn.elevation = {-3600_deg, 3600_deg};
        const PermittedRegion region(drawn, kRouteAzimuths, {0_deg, 90_deg});
        const AxisPosition from = make.place(kRouteAzimuths, {0_deg, 90_deg});
        const AxisPosition to = make.place(kRouteAzimuths, {0_deg, 90_deg});
        for (double level = 0.0; level <= 90.0; level += 1.0) {
            const std::vector over{AxisPosition{from.azimuth, Angle::fromDegrees(level)},
                                   AxisPosition{to.azimuth, Angle::fromDegrees(level)}, to};
            AxisPosition last = from;
            bool possible = true;
            for (const AxisPosition& place : over) {
                possible = possible && region.permits(AxisBox::between(last, place));
                last = place;
            }
            if (possible) {
                const auto way = route(region, from, to, kSpeed, Seconds(0.0));
                ASSERT_TRUE(way);
                EXPECT_LE(duration(from, *way), duration(from, over) + 1e-6);
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 1000);
}

// Story: 60 keep-outs around a target delayed the control tick by 0.15 s.
// REQ-POINTING-16a: A search ends after a fixed number of steps, also without a route, and its error names the cause.
// With the largest number of keep-outs in a profile it ends earlier.
TEST(Route, GivesUpAfterSoManySteps)
{
    const PermittedRegion region({.keepOuts = {routeMast()}}, kRouteAzimuths, {0_deg, 90_deg});
    const auto none = route(region, at(290, 10), at(340, 5), kSpeed, Seconds(0.5), 10);
    ASSERT_FALSE(none);
    EXPECT_EQ(textOf(none.error()),
              "Boresight found no way from 290.0° 10.0° to 340.0° 5.0° in time. There are too many keep-outs.");
    EXPECT_TRUE(route(region, at(290, 10), at(300, 60), kSpeed, Seconds(0.5), 0)) << "a direct way needs no search";
    EXPECT_TRUE(route(region, at(290, 10), at(340, 5), kSpeed, Seconds(0.5), 1000));
}

// With the largest number of keep-outs in a profile, all around a leaning mount, a route is found within these steps.
// REQ-POINTING-16a
TEST(Route, FindsItsWayAmongAsManyKeepOutsAsThereMayBe)
{
    std::mt19937 random(11);
    fakes::RandomRegion make(random);
    const PointingModel leaning({.tiltNorth = 0.5_deg, .tiltEast = 0.3_deg, .collimation = 0.3_deg});
    int found = 0;
    for (int round = 0; round < 10; ++round) {
        Region drawn;
        for (int i = 0; i < 32; ++i) {
            const double from = make.uniform(0, 350);
            const double bottom = make.uniform(0, 60);
            drawn.keepOuts.push_back({.name = std::to_string(i),
                                      .azimuthFrom = Angle::fromDegrees(from),
                                      .azimuthTo = Angle::fromDegrees(from + make.uniform(2, 10)),
                                      .elevationMin = Angle::fromDegrees(bottom),
                                      .elevationMax = Angle::fromDegrees(bottom + make.uniform(2, 15))});
        }
        const PermittedRegion region(drawn, kRouteAzimuths, {0_deg, 180_deg}, leaning);
        for (int i = 0; i < 10; ++i) {
            const AxisPosition from = *nearestPermitted(region, make.place(kRouteAzimuths, {0_deg, 180_deg}));
            const AxisPosition to = *nearestPermitted(region, make.place(kRouteAzimuths, {0_deg, 180_deg}));
            const auto way = route(region, from, to, kSpeed);
            if (way) {
                expectPermitted(region, from, *way);
                ++found;
            } else {
                EXPECT_EQ(textOf(way.error()).find("in time"), std::string::npos) << textOf(way.error());
            }
        }
    }
    EXPECT_GT(found, 80);
}
