// SPDX-License-Identifier: GPL-3.0-or-later
// PermittedRegion::nearest: the nearest permitted place lies at the azimuth asked for, at an edge of a keep-out or a
// limit, at a corner of the horizon, at the foot of the shortest way to one of its lines, or where a line crosses the
// elevation of an edge. Lines farther away than the best place so far are passed over.
#include "core/pointing/permitted_region.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace boresight::pointing {

namespace {

const Angle kFullTurn = Angle::fromTurns(1.0);

class Search
{
public:
    Search(const PermittedRegion& region, const AxisPosition& wanted)
        : m_region(region),
          m_wanted(wanted),
          // At the zenith any azimuth would do: keep a little, so that the axis does not turn for nothing.
          m_width(std::max(0.05, std::abs(std::cos(wanted.elevation.radians()))))
    {
        const TravelRange& elevations = region.ranges().elevation;
        m_levels = {elevations.clamped(wanted.elevation), elevations.min, elevations.max};
        for (const AxisBox& keepOut : region.keepOuts()) {
            m_levels.push_back(keepOut.elevation.min);
            m_levels.push_back(keepOut.elevation.max);
        }
    }

    void tryAzimuth(Angle azimuth)
    {
        if (std::abs((azimuth - m_wanted.azimuth).radians()) * m_width >= m_bestDistance) {
            return;
        }
        for (const Angle level : m_levels) {
            tryPlace({azimuth, level});
        }
        const TravelRange here{azimuth, azimuth};
        tryPlace({azimuth, m_region.floor(here)});
        tryPlace({azimuth, m_region.ceiling(here)});
    }

    // A line of the horizon, or its image over the top, as the axes see it.
    void tryLine(const HorizonPoint& a, const HorizonPoint& b)
    {
        const Angle past = std::max(a.azimuth - m_wanted.azimuth, m_wanted.azimuth - b.azimuth);
        if (past.radians() * m_width >= m_bestDistance) {
            return;
        }
        tryAzimuth(a.azimuth);
        tryAzimuth(b.azimuth);
        const double slope = (b.elevation - a.elevation) / (b.azimuth - a.azimuth);
        const double square = m_width * m_width;
        const Angle foot =
            (square * m_wanted.azimuth + slope * (m_wanted.elevation - a.elevation + slope * a.azimuth)) /
            (square + slope * slope);
        tryOn(a, b, foot);
        for (const Angle level : m_levels) {
            tryOn(a, b, a.azimuth + (level - a.elevation) / slope);
        }
    }

    [[nodiscard]] std::optional<AxisPosition> best() const { return m_best; }

private:
    void tryOn(const HorizonPoint& a, const HorizonPoint& b, Angle azimuth)
    {
        if (azimuth > a.azimuth && azimuth < b.azimuth) {
            tryAzimuth(azimuth);
        }
    }

    void tryPlace(const AxisPosition& place)
    {
        const double distance = std::hypot(m_width * (place.azimuth - m_wanted.azimuth).radians(),
                                           (place.elevation - m_wanted.elevation).radians());
        if (distance < m_bestDistance && m_region.permits(place)) {
            m_best = place;
            m_bestDistance = distance;
        }
    }

    const PermittedRegion& m_region;
    AxisPosition m_wanted;
    double m_width;
    std::vector<Angle> m_levels;
    std::optional<AxisPosition> m_best;
    double m_bestDistance = std::numeric_limits<double>::infinity();
};

}  // namespace

std::optional<AxisPosition> PermittedRegion::nearest(const AxisPosition& place) const
{
    if (permits(place)) {
        return place;
    }
    Search search(*this, place);
    search.tryAzimuth(m_ranges.azimuth.clamped(place.azimuth));
    for (const AxisBox& keepOut : m_boxes) {
        search.tryAzimuth(keepOut.azimuth.min);
        search.tryAzimuth(keepOut.azimuth.max);
    }
    search.tryAzimuth(m_ranges.azimuth.min);
    search.tryAzimuth(m_ranges.azimuth.max);
    const double first = std::floor(m_ranges.azimuth.min / kFullTurn) - 2.0;
    const double last = std::ceil(m_ranges.azimuth.max / kFullTurn) + 1.0;
    for (double turn = first; turn <= last; turn += 1.0) {
        const Angle by = turn * kFullTurn;
        for (std::size_t i = 0; i < m_upright.lineCount(); ++i) {
            const auto [from, to] = m_upright.line(i);
            search.tryLine({from.azimuth + by, from.elevation}, {to.azimuth + by, to.elevation});
        }
        for (std::size_t i = 0; i < m_overTheTop.lineCount(); ++i) {
            const auto [from, to] = m_overTheTop.line(i);
            search.tryLine({from.azimuth + by + 180_deg, 180_deg - from.elevation},
                           {to.azimuth + by + 180_deg, 180_deg - to.elevation});
        }
    }
    return search.best();
}

}  // namespace boresight::pointing
