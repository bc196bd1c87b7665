// SPDX-License-Identifier: GPL-3.0-or-later
// The forbidden places are a set of rectangles: the keep-outs in axis angles, and the highest horizon between the
// azimuths at which anything begins or ends. If there is a way, there is one from corner to corner of these rectangles.
// So only the corners are candidates for turning. A* searches the quickest way among them.
#include "core/pointing/route.h"

#include "core/base/text.h"
#include "core/pointing/nearest_permitted.h"
#include "core/pointing/ranges.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace boresight::pointing {

namespace {

const Angle kHardly = Angle::fromDegrees(1e-6);

// The number of steps that a search may still use.
class Effort
{
public:
    explicit Effort(std::size_t steps) : m_left(steps) {}

    // True if that many steps were left. If not, no steps are left afterwards.
    bool spend(std::size_t steps)
    {
        m_left = steps < m_left ? m_left - steps : 0;
        return !spent();
    }
    [[nodiscard]] bool spent() const { return m_left == 0; }

private:
    std::size_t m_left;
};

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
        // The horizontal reach, until the horizon rises above it.
        const TravelRange level = region.azimuthsAround(AxisBox::at(end));
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

// A place where the route may turn. At a corner of a rectangle the route leads from one neighbouring quadrant to the
// opposite one: upper right and lower left for a `Falling` corner, the other two for a `Rising` corner.
enum class Turn
{
    Anyhow,  // start or end of the route
    Falling,
    Rising
};

struct Place
{
    AxisPosition at;
    Turn turn = Turn::Anyhow;

    // True if a leg to or from `other` can belong to a route around this corner.
    [[nodiscard]] bool leadsTo(const AxisPosition& other) const
    {
        const double rise = (other.azimuth - at.azimuth).degrees() * (other.elevation - at.elevation).degrees();
        constexpr double kLevel = 1e-9;
        return turn == Turn::Anyhow || (turn == Turn::Falling ? rise > -kLevel : rise < kLevel);
    }
    bool operator==(const Place&) const = default;
};

void addCorners(std::vector<Place>& places, const AxisBox& keepOut)
{
    const auto& [azimuth, elevation] = keepOut;
    places.push_back({{azimuth.min, elevation.min}, Turn::Rising});
    places.push_back({{azimuth.min, elevation.max}, Turn::Falling});
    places.push_back({{azimuth.max, elevation.min}, Turn::Falling});
    places.push_back({{azimuth.max, elevation.max}, Turn::Rising});
}

// Adds the places where the highest horizon of a column meets that of a lower column.
void addSteps(std::vector<Place>& places, const PermittedRegion& region, const std::vector<Angle>& sides)
{
    for (std::size_t i = 1; i + 1 < sides.size(); ++i) {
        const TravelRange before{sides[i - 1], sides[i]};
        const TravelRange after{sides[i], sides[i + 1]};
        const Angle floor = region.floor(before);
        const Angle nextFloor = region.floor(after);
        if (floor != nextFloor) {
            places.push_back(
                {{sides[i], std::max(floor, nextFloor)}, floor < nextFloor ? Turn::Falling : Turn::Rising});
        }
        const Angle ceiling = region.ceiling(before);
        const Angle nextCeiling = region.ceiling(after);
        if (ceiling != nextCeiling) {
            places.push_back(
                {{sides[i], std::min(ceiling, nextCeiling)}, nextCeiling < ceiling ? Turn::Rising : Turn::Falling});
        }
    }
}

// The first two places are the ends of the route.
std::vector<Place> turningPlaces(const PermittedRegion& region, const AxisPosition& from, const AxisPosition& to,
                                 Effort& effort)
{
    std::vector<Place> corners;
    for (const AxisBox& keepOut : region.keepOuts()) {
        addCorners(corners, keepOut);
    }
    if (region.hasHorizonLine()) {
        addSteps(corners, region, columns(region, from, to));
    }
    std::ranges::sort(corners, {},
                      [](const Place& one) { return std::tuple(one.at.azimuth, one.at.elevation, one.turn); });
    const auto same = std::ranges::unique(corners);
    corners.erase(same.begin(), same.end());
    std::vector<Place> places{{from}, {to}};
    for (const Place& corner : corners) {
        if (effort.spend(region.keepOuts().size()) && region.permits(corner.at)) {
            places.push_back(corner);
        }
    }
    return places;
}

double duration(const AxisPosition& a, const AxisPosition& b, const AxisRates& speed)
{
    return std::max(abs(b.azimuth - a.azimuth).radians() / speed.azimuth.radians(),
                    abs(b.elevation - a.elevation).radians() / speed.elevation.radians());
}

bool contains(const AxisBox& box, const AxisPosition& place)
{
    return box.azimuth.contains(place.azimuth) && box.elevation.contains(place.elevation);
}

// A* from places[0] to places[1].
class QuickestWay
{
public:
    QuickestWay(const PermittedRegion& region, std::vector<Place> places, const AxisRates& speed, double bend,
                Effort& effort)
        : m_region(region),
          m_places(std::move(places)),
          m_speed(speed),
          m_bend(bend),
          m_effort(effort),
          m_endSight(inSight(m_places[1].at)),
          m_visits(m_places.size())
    {
        m_visits[0] = {.time = 0.0, .left = left(0)};
    }

    // Empty if there is no way, or if the steps are used up.
    [[nodiscard]] std::optional<std::vector<AxisPosition>> find()
    {
        while (const auto here = nextOpen()) {
            if (*here == 1) {
                return wayTo(1);
            }
            if (!m_effort.spend(m_places.size() + 2 * m_region.keepOuts().size())) {
                return std::nullopt;
            }
            m_visits[*here].done = true;
            const AxisBox sight = inSight(m_places[*here].at);
            for (std::size_t there = 1; there < m_places.size(); ++there) {
                reach(*here, there, sight);
            }
        }
        return std::nullopt;
    }

private:
    struct Visit
    {
        double time = std::numeric_limits<double>::infinity();  // from the start
        double left = 0.0;                                      // lower bound of the time to the end
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

    // How far each axis can move alone. No leg leads beyond that. The horizon is queried from slightly above the place,
    // so that rounding does not turn level ground into an obstacle.
    [[nodiscard]] AxisBox inSight(const AxisPosition& place) const
    {
        const AxisBox thin{.azimuth = {place.azimuth, place.azimuth},
                           .elevation = {place.elevation + kHardly, place.elevation - kHardly}};
        const TravelRange azimuths = m_region.azimuthsAround(thin);
        const TravelRange elevations = m_region.elevationsAround(AxisBox::at(place));
        return {.azimuth = {azimuths.min - kHardly, azimuths.max + kHardly},
                .elevation = {elevations.min - kHardly, elevations.max + kHardly}};
    }

    void reach(std::size_t here, std::size_t there, const AxisBox& sight)
    {
        Visit& visit = m_visits[there];
        const Place& from = m_places[here];
        const Place& to = m_places[there];
        if (visit.done || !contains(sight, to.at) || !from.leadsTo(to.at) || !to.leadsTo(from.at)) {
            return;
        }
        const double time = m_visits[here].time + duration(from.at, to.at, m_speed) + m_bend;
        if (time < visit.time && m_effort.spend(m_region.keepOuts().size()) &&
            m_region.permits(AxisBox::between(from.at, to.at))) {
            visit = {.time = time, .left = left(there), .before = here};
        }
    }

    // At least one more leg, or two if the end is not in sight.
    [[nodiscard]] double left(std::size_t place) const
    {
        const double legs = place == 1 ? 0.0 : contains(m_endSight, m_places[place].at) ? 1.0 : 2.0;
        return duration(m_places[place].at, m_places[1].at, m_speed) + legs * m_bend;
    }

    [[nodiscard]] std::vector<AxisPosition> wayTo(std::size_t place) const
    {
        std::vector<AxisPosition> way;
        for (; place != 0; place = m_visits[place].before) {
            way.push_back(m_places[place].at);
        }
        std::ranges::reverse(way);
        return way;
    }

    const PermittedRegion& m_region;
    std::vector<Place> m_places;
    AxisRates m_speed;
    double m_bend;
    Effort& m_effort;
    AxisBox m_endSight;
    std::vector<Visit> m_visits;
};

// The first obstacle on the straight line from the first place to the second.
QString obstacleBetween(const PermittedRegion& region, const AxisPosition& from, const AxisPosition& to)
{
    constexpr int kSteps = 2000;
    for (int i = 1; i < kSteps; ++i) {
        const double part = static_cast<double>(i) / kSteps;
        const AxisPosition place{.azimuth = from.azimuth + part * (to.azimuth - from.azimuth),
                                 .elevation = from.elevation + part * (to.elevation - from.elevation)};
        if (const QString obstacle = region.obstacle(place); !obstacle.isEmpty()) {
            return obstacle;
        }
    }
    return Text::tr("a forbidden region");
}

QString degrees(const SkyPointing& beam)
{
    const SkyPointing direction = upright(beam);
    return azimuthText(direction.azimuth) + u' ' + degreesText(direction.elevation);
}

Error noWay(const PermittedRegion& region, const AxisPosition& from, const AxisPosition& to, bool spent)
{
    const QString begin = degrees(region.beamAt(from));
    const QString end = degrees(region.beamAt(to));
    const QString text =
        spent ? Text::tr("Boresight found no way from %1 to %2 in time. There are too many keep-outs.").arg(begin, end)
              : Text::tr("There is no way from %1 to %2. Between them is %3.")
                    .arg(begin, end, obstacleBetween(region, from, to));
    return {ErrorCode::OutOfRange, text};
}

}  // namespace

Result<std::vector<AxisPosition>> route(const PermittedRegion& region, const AxisPosition& from, const AxisPosition& to,
                                        const AxisRates& speed, Seconds bend, std::size_t steps)
{
    if (!region.permits(to)) {
        return failure(ErrorCode::OutOfRange, region.reason(to));
    }
    if (region.permits(AxisBox::between(from, to))) {
        return std::vector{to};
    }
    const auto start = nearestPermitted(region, from);  // leaves a forbidden place first
    std::vector<AxisPosition> way;
    if (*start != from) {
        way.push_back(*start);
    }
    if (*start == to) {
        return way;
    }
    Effort effort(steps);
    const auto further =
        QuickestWay(region, turningPlaces(region, *start, to, effort), speed, bend.count(), effort).find();
    if (!further) {
        return tl::unexpected(noWay(region, *start, to, effort.spent()));
    }
    way.insert(way.end(), further->begin(), further->end());
    return way;
}

}  // namespace boresight::pointing
