// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/nearest_permitted.h"

#include "core/pointing/permitted_region.h"
#include "core/pointing/ranges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace boresight::pointing {

namespace {

constexpr TravelRange kAll{.min = Angle::fromDegrees(-1e6), .max = Angle::fromDegrees(1e6)};

Angle gap(const TravelRange& range, Angle angle)
{
    return std::max({range.min - angle, angle - range.max, Angle{}});
}

// The nearest permitted place is one of these candidates: the wanted azimuth or elevation on an edge of a keep-out or a
// limit, the crossing of two such edges, a corner of the horizon, the foot of the perpendicular to a line of the
// horizon, or the crossing of a line and an edge. Candidates farther away than the best place so far are skipped.
class Search
{
public:
    Search(const PermittedRegion& region, const AxisPosition& wanted)
        : m_region(region),
          m_wanted(wanted),
          // At the zenith any azimuth would do. A small weight remains, so that the axis does not turn without need.
          m_width(std::max(0.05, std::abs(std::cos(wanted.elevation.radians()))))
    {
        const TravelRange& elevations = region.ranges().elevation;
        m_levels = {{elevations.clamped(wanted.elevation), kAll}, {elevations.min, kAll}, {elevations.max, kAll}};
        for (const AxisBox& keepOut : region.keepOuts()) {
            m_levels.push_back({keepOut.elevation.min, keepOut.azimuth});
            m_levels.push_back({keepOut.elevation.max, keepOut.azimuth});
        }
    }

    // Tries an edge at this azimuth and everything that crosses it.
    void tryAzimuth(Angle azimuth, const TravelRange& elevations = kAll)
    {
        if (squareOf(abs(azimuth - m_wanted.azimuth), gap(elevations, m_wanted.elevation)) >= m_bestSquare) {
            return;
        }
        for (const Level& level : m_levels) {
            if (reaches(elevations, level.elevation) && reaches(level.azimuths, azimuth)) {
                tryPlace({azimuth, level.elevation});
            }
        }
        tryGround(azimuth);
    }

    // Tries a line of the horizon, or its image over the top, in axis angles.
    void tryLine(const HorizonPoint& a, const HorizonPoint& b)
    {
        const TravelRange heights{std::min(a.elevation, b.elevation), std::max(a.elevation, b.elevation)};
        if (squareOf(gap({a.azimuth, b.azimuth}, m_wanted.azimuth), gap(heights, m_wanted.elevation)) >= m_bestSquare) {
            return;
        }
        tryGround(a.azimuth);
        tryGround(b.azimuth);
        const double slope = (b.elevation - a.elevation) / (b.azimuth - a.azimuth);
        const double square = m_width * m_width;
        const Angle foot =
            (square * m_wanted.azimuth + slope * (m_wanted.elevation - a.elevation + slope * a.azimuth)) /
            (square + slope * slope);
        if (foot > a.azimuth && foot < b.azimuth) {
            tryGround(foot);
        }
        for (const Level& level : m_levels) {
            const Angle crossing = a.azimuth + (level.elevation - a.elevation) / slope;
            if (crossing > a.azimuth && crossing < b.azimuth && reaches(level.azimuths, crossing)) {
                tryPlace({crossing, level.elevation});
            }
        }
    }

    [[nodiscard]] std::optional<AxisPosition> best() const { return m_best; }

private:
    // An elevation along which the axes can move at these azimuths.
    struct Level
    {
        Angle elevation;
        TravelRange azimuths;
    };

    [[nodiscard]] double squareOf(Angle azimuth, Angle elevation) const
    {
        const double across = m_width * azimuth.radians();
        return across * across + elevation.radians() * elevation.radians();
    }

    void tryGround(Angle azimuth)
    {
        if (squareOf(azimuth - m_wanted.azimuth, {}) < m_bestSquare && m_region.hasHorizonLine()) {
            const TravelRange here{azimuth, azimuth};
            tryPlace({azimuth, m_region.floor(here)});
            tryPlace({azimuth, m_region.ceiling(here)});
        }
    }

    void tryPlace(const AxisPosition& place)
    {
        const double square = squareOf(place.azimuth - m_wanted.azimuth, place.elevation - m_wanted.elevation);
        if (square < m_bestSquare && m_region.permits(place)) {
            m_best = place;
            m_bestSquare = square;
        }
    }

    const PermittedRegion& m_region;
    AxisPosition m_wanted;
    double m_width;
    std::vector<Level> m_levels;
    std::optional<AxisPosition> m_best;
    double m_bestSquare = std::numeric_limits<double>::infinity();
};

}  // namespace

std::optional<AxisPosition> nearestPermitted(const PermittedRegion& region, const AxisPosition& place)
{
    if (region.permits(place)) {
        return place;
    }
    Search search(region, place);
    const TravelRange& azimuths = region.ranges().azimuth;
    search.tryAzimuth(azimuths.clamped(place.azimuth));
    for (const AxisBox& keepOut : region.keepOuts()) {
        search.tryAzimuth(keepOut.azimuth.min, keepOut.elevation);
        search.tryAzimuth(keepOut.azimuth.max, keepOut.elevation);
    }
    search.tryAzimuth(azimuths.min);
    search.tryAzimuth(azimuths.max);
    const double first = std::floor(azimuths.min / kFullTurn) - 2.0;
    const double last = std::ceil(azimuths.max / kFullTurn) + 1.0;
    for (double turn = first; turn <= last; turn += 1.0) {
        const Angle by = turn * kFullTurn;
        for (std::size_t i = 0; i < region.horizon().lineCount(); ++i) {
            const auto [from, to] = region.horizon().line(i);
            search.tryLine({from.azimuth + by, from.elevation}, {to.azimuth + by, to.elevation});
        }
        for (std::size_t i = 0; i < region.overTheTop().lineCount(); ++i) {
            const auto [from, to] = region.overTheTop().line(i);
            search.tryLine({from.azimuth + by + 180_deg, 180_deg - from.elevation},
                           {to.azimuth + by + 180_deg, 180_deg - to.elevation});
        }
    }
    return search.best();
}

std::optional<AxisPosition> easyPermitted(const PermittedRegion& region, const AxisPosition& place)
{
    const auto& [azimuths, elevations] = region.ranges();
    if (azimuths.min > azimuths.max || elevations.min > elevations.max) {
        return std::nullopt;
    }
    const AxisPosition inside{azimuths.clamped(place.azimuth), elevations.clamped(place.elevation)};
    AxisPosition above = inside;
    while (!region.permits(above)) {
        above.elevation = Angle::fromDegrees(std::floor(above.elevation.degrees() + 1.0 + 1e-9));
        if (above.elevation > elevations.max) {
            return nearestPermitted(region, inside);
        }
    }
    return above;
}

}  // namespace boresight::pointing
