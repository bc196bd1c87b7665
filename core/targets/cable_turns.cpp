// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/targets/cable_turns.h"

#include "core/pointing/ranges.h"
#include "core/tracking/cable_room.h"

#include <algorithm>
#include <tuple>

namespace boresight::targets {

namespace {

// A pass begins and ends at the horizon, which is also the end of many travels. The times are rounded, so this
// tolerance is needed.
constexpr Angle kAtTheRim = Angle::fromDegrees(0.01);

// The part of the time between two moments in which the limits hide neither of them.
Seconds seenBetween(const SkyMoment& from, const SkyMoment& to, UtcTime begin, UtcTime end)
{
    if (from.isHidden || to.isHidden) {
        return Seconds(0.0);
    }
    return std::max(Seconds(0.0), Seconds(std::min(to.utc, end) - std::max(from.utc, begin)));
}

Seconds seenWithin(const std::vector<SkyMoment>& way, UtcTime begin, UtcTime end)
{
    Seconds seen{0.0};
    for (std::size_t i = 1; i < way.size(); ++i) {
        seen += seenBetween(way[i - 1], way[i], begin, end);
    }
    return seen;
}

// Where the cable ends between two moments.
UtcTime crossing(const SkyMoment& from, const SkyMoment& to, const TravelRange& range, Angle here, Angle near)
{
    const Angle end = near > here ? range.max : range.min;
    const double part = near == here ? 0.0 : std::clamp((end - here) / (near - here), 0.0, 1.0);
    return from.utc + std::chrono::round<UtcTime::duration>(part * Seconds(to.utc - from.utc));
}

// Starts on one wrap and resolves each direction as the station does.
CableTurns turnsFrom(AxisPosition place, const std::vector<SkyMoment>& way, const MountReach& reach)
{
    const auto turnTime = std::chrono::round<UtcTime::duration>(tracking::fullTurnTime(reach.turning));
    CableTurns found;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const AxisPosition next = reach.model.resolve(way[i].direction, place).position;
        if (abs(next.azimuth - place.azimuth) > 180_deg) {
            const Angle near = next.azimuth.nearestTo(place.azimuth);
            const UtcTime begins = crossing(way[i - 1], way[i], reach.azimuths, place.azimuth, near);
            ++found.turns;
            found.lost += seenWithin(way, begins, begins + turnTime);
        }
        place = next;
    }
    return found;
}

// Every wrap on which the mount may wait. The station later takes the nearest one.
std::vector<AxisPosition> starts(const SkyPointing& direction, const MountReach& reach)
{
    const AxisPosition axes = reach.model.pointing().toAxes(direction).axes;
    tracking::SweptArc place;
    place.add(axes.azimuth);
    const tracking::WholeTurns wraps = place.turnsInside(reach.azimuths);
    std::vector<AxisPosition> all;
    for (int wrap = wraps.first; wrap <= wraps.last; ++wrap) {
        all.push_back({axes.azimuth + Angle::fromTurns(wrap), axes.elevation});
    }
    if (all.empty()) {  // for a direction beyond its travel the mount waits at an end
        all.push_back(reach.model.resolve(direction, axes).position);
    }
    return all;
}

bool fitsOverTheTop(const std::vector<SkyMoment>& way, const MountReach& reach)
{
    tracking::SweptArc arc;
    for (const SkyMoment& moment : way) {
        const SkyPointing over{moment.direction.azimuth + 180_deg, 180_deg - moment.direction.elevation};
        const AxisPosition axes = reach.model.pointing().toAxes(over).axes;
        if (!moment.isHidden && abs(axes.elevation - reach.elevations.clamped(axes.elevation)) > kAtTheRim) {
            return false;
        }
        arc.add(axes.azimuth);
    }
    return arc.turnsInside(reach.azimuths).any();
}

}  // namespace

bool MountReach::operator==(const MountReach& other) const
{
    const auto parts = [](const MountReach& one) {
        return std::tuple(one.model.azimuth(), one.model.elevation(), one.model.pointing().terms(), one.model.missing(),
                          one.azimuths, one.elevations, one.turning);
    };
    return parts(*this) == parts(other);
}

MountReach reachOf(const profile::Profile& profile, const pointing::Antenna& antenna)
{
    const pointing::PointingModel pointing(profile.termsOf(antenna));
    const pointing::AxisGeometry& azimuth = profile.azimuth.geometry;
    const pointing::AxisGeometry& elevation = profile.elevation.geometry;
    MountReach reach{.model = pointing::MountModel(azimuth, elevation, pointing),
                     .azimuths = pointing::common(profile.limits.azimuth, azimuth.travel),
                     .elevations = pointing::common(profile.limits.elevation, elevation.travel),
                     .turning = profile.azimuth.limits};
    if (const auto missing = profile.missing()) {
        reach.model.leaveOut(*missing);
    }
    reach.model.limitTo(reach.azimuths, reach.elevations);
    return reach;
}

CableTurns cableTurns(const std::vector<SkyMoment>& way, const MountReach& reach)
{
    if (way.empty() || reach.model.missing() == Axis::Azimuth || reach.model.pointing().isXY()) {
        return {};
    }
    tracking::SweptArc arc;
    for (const SkyMoment& moment : way) {
        arc.add(reach.model.pointing().toAxes(moment.direction).axes.azimuth);
    }
    if (arc.turnsInside(reach.azimuths).any()) {
        return {};
    }
    CableTurns worst;
    for (const AxisPosition& place : starts(way.front().direction, reach)) {
        const CableTurns found = turnsFrom(place, way, reach);
        worst = std::tie(found.lost, found.turns) > std::tie(worst.lost, worst.turns) ? found : worst;
    }
    worst.hasRoom = false;
    worst.hasGap = reach.azimuths.max - reach.azimuths.min < pointing::kFullTurn - kAtTheRim;
    worst.fitsOverTheTop = worst.lost > Seconds(0.0) && fitsOverTheTop(way, reach);
    return worst;
}

}  // namespace boresight::targets
