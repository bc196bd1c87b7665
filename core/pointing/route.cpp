// SPDX-License-Identifier: GPL-3.0-or-later
// The azimuths at which anything begins or ends cut the range into columns. Within a column keep-outs go all the way
// across, so that what is free in it are a few bands of elevation, above the highest point of its horizon; a way that
// exists at all leads from band to band. The places worth turning at are therefore the ends of the bands at the sides
// of the columns, and the elevations of both ends of the way. Among them the quickest way is searched (A*).
#include "core/pointing/route.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace boresight::pointing {

namespace {

const Angle kRounding = Angle::fromDegrees(1e-9);

void sortUnique(std::vector<Angle>& angles)
{
    std::ranges::sort(angles);
    const auto same = std::ranges::unique(angles, [](Angle a, Angle b) { return b - a <= kRounding; });
    angles.erase(same.begin(), same.end());
}

std::vector<Angle> columns(const PermittedRegion& region, const AxisPosition& from, const AxisPosition& to)
{
    const TravelRange& range = region.ranges().azimuth;
    std::vector<Angle> sides{from.azimuth, to.azimuth, range.min, range.max};
    for (const AxisPosition& end : {from, to}) {
        const TravelRange level = region.azimuthsAround(AxisBox::at(end));  // until the horizon rises above it
        sides.push_back(level.min);
        sides.push_back(level.max);
    }
    for (const AxisBox& keepOut : region.keepOuts()) {
        sides.push_back(range.clamped(keepOut.azimuth.min));
        sides.push_back(range.clamped(keepOut.azimuth.max));
    }
    sortUnique(sides);
    return sides;
}

// The ends of the free bands of a column.
std::vector<Angle> bandEnds(const PermittedRegion& region, const TravelRange& column)
{
    const TravelRange& range = region.ranges().elevation;
    std::vector<Angle> ends{std::max(range.min, region.floor(column)), std::min(range.max, region.ceiling(column))};
    for (const AxisBox& keepOut : region.keepOuts()) {
        if (keepOut.azimuth.max > column.min + kRounding && keepOut.azimuth.min < column.max - kRounding) {
            ends.push_back(keepOut.elevation.min);
            ends.push_back(keepOut.elevation.max);
        }
    }
    std::erase_if(ends, [&](Angle end) {
        return !region.permits(AxisBox{.azimuth = column, .elevation = {end, end}});
    });
    return ends;
}

std::vector<AxisPosition> turningPlaces(const PermittedRegion& region, const AxisPosition& from, const AxisPosition& to)
{
    std::vector<AxisPosition> places{from, to};
    const std::vector<Angle> sides = columns(region, from, to);
    std::vector<Angle> before;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        std::vector<Angle> after =
            i + 1 < sides.size() ? bandEnds(region, {sides[i], sides[i + 1]}) : std::vector<Angle>{};
        std::vector<Angle> levels = std::move(before);
        levels.insert(levels.end(), after.begin(), after.end());
        levels.insert(levels.end(), {from.elevation, to.elevation});
        sortUnique(levels);
        for (const Angle level : levels) {
            if (const AxisPosition place{sides[i], level}; region.permits(place)) {
                places.push_back(place);
            }
        }
        before = std::move(after);
    }
    return places;
}

double duration(const AxisPosition& a, const AxisPosition& b, const AxisRates& speed)
{
    return std::max(abs(b.azimuth - a.azimuth).radians() / speed.azimuth.radians(),
                    abs(b.elevation - a.elevation).radians() / speed.elevation.radians());
}

// A* from places[0] to places[1].
class QuickestWay
{
public:
    QuickestWay(const PermittedRegion& region, std::vector<AxisPosition> places, const AxisRates& speed, double bend)
        : m_region(region), m_places(std::move(places)), m_speed(speed), m_bend(bend), m_visits(m_places.size())
    {
        m_visits[0] = {.time = 0.0, .left = duration(m_places[0], m_places[1], speed)};
    }

    [[nodiscard]] std::optional<std::vector<AxisPosition>> find()
    {
        while (const auto here = nextOpen()) {
            if (*here == 1) {
                return wayTo(1);
            }
            m_visits[*here].done = true;
            for (std::size_t there = 1; there < m_places.size(); ++there) {
                reach(*here, there);
            }
        }
        return std::nullopt;
    }

private:
    struct Visit
    {
        double time = std::numeric_limits<double>::infinity();  // from the start
        double left = 0.0;                                      // at least, to the end
        std::size_t before = 0;
        bool done = false;
    };

    [[nodiscard]] std::optional<std::size_t> nextOpen() const
    {
        std::optional<std::size_t> best;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < m_visits.size(); ++i) {
            const Visit& visit = m_visits[i];
            if (!visit.done && visit.time + visit.left < least) {
                least = visit.time + visit.left;
                best = i;
            }
        }
        return best;
    }

    void reach(std::size_t here, std::size_t there)
    {
        Visit& visit = m_visits[there];
        const double time = m_visits[here].time + duration(m_places[here], m_places[there], m_speed) + m_bend;
        if (!visit.done && time < visit.time && m_region.permits(AxisBox::between(m_places[here], m_places[there]))) {
            visit = {.time = time, .left = duration(m_places[there], m_places[1], m_speed), .before = here};
        }
    }

    [[nodiscard]] std::vector<AxisPosition> wayTo(std::size_t place) const
    {
        std::vector<AxisPosition> way;
        for (; place != 0; place = m_visits[place].before) {
            way.push_back(m_places[place]);
        }
        std::ranges::reverse(way);
        return way;
    }

    const PermittedRegion& m_region;
    std::vector<AxisPosition> m_places;
    AxisRates m_speed;
    double m_bend;
    std::vector<Visit> m_visits;
};

// What stands on the straight line between two places, as seen from the first.
std::string obstacleBetween(const PermittedRegion& region, const AxisPosition& from, const AxisPosition& to)
{
    constexpr int kSteps = 2000;
    for (int i = 1; i < kSteps; ++i) {
        const double part = static_cast<double>(i) / kSteps;
        const AxisPosition place{.azimuth = from.azimuth + part * (to.azimuth - from.azimuth),
                                 .elevation = from.elevation + part * (to.elevation - from.elevation)};
        if (const std::string obstacle = region.obstacle(place); !obstacle.empty()) {
            return obstacle;
        }
    }
    return Text::tr("what is forbidden").toStdString();
}

QString degrees(const SkyPointing& beam)
{
    return toQString(formatFixed(beam.azimuth.degrees(), 1) + "° " + formatFixed(beam.elevation.degrees(), 1) + "°");
}

}  // namespace

Result<std::vector<AxisPosition>> route(const PermittedRegion& region, const AxisPosition& from, const AxisPosition& to,
                                        const AxisRates& speed, Seconds bend)
{
    if (!region.permits(to)) {
        return failure(ErrorCode::OutOfRange, region.reason(to));
    }
    if (region.permits(AxisBox::between(from, to))) {
        return std::vector{to};
    }
    const auto start = region.nearest(from);  // out of a forbidden place first
    std::vector<AxisPosition> way;
    if (*start != from) {
        way.push_back(*start);
    }
    if (*start == to) {
        return way;
    }
    const auto further = QuickestWay(region, turningPlaces(region, *start, to), speed, bend.count()).find();
    if (!further) {
        return failure(ErrorCode::OutOfRange, Text::tr("there is no way from %1 to %2: %3 is in between")
                                                  .arg(degrees(region.beamAt(from)), degrees(region.beamAt(to)),
                                                       toQString(obstacleBetween(region, *start, to))));
    }
    way.insert(way.end(), further->begin(), further->end());
    return way;
}

}  // namespace boresight::pointing
