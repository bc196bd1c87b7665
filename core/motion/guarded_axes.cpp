// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/guarded_axes.h"

#include "core/pointing/missing_axis.h"
#include "core/pointing/nearest_permitted.h"
#include "core/pointing/ranges.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight {
namespace {

using pointing::AxisBox;
using tracking::AxisSetpoints;

// The region that an edge belongs to is looked up this far beyond the edge.
constexpr Angle kBeyondEdge = Angle::fromDegrees(0.1);

// A rotator that moves by itself is never exactly at its set-points.
constexpr Angle kNearly = Angle::fromDegrees(0.5);
constexpr Seconds kStands{3.0};
constexpr Seconds kLeftBehind{8.0};  // its driver reports a blocked axis earlier
// When no motion is wanted any more, the rotator must not follow its set-points over more than this.
constexpr Angle kRunsAfter = Angle::fromDegrees(3.0);

AxisSetpoints profileOf(const profile::AxisSettings& axis, const TravelRange& travel)
{
    return {axis.limits, travel, travel.clamped(Angle{})};
}

void obey(AxisSetpoints& axis, Seconds duration, const AxisWish& wish)
{
    if (wish.braking) {
        axis.brake(duration, *wish.braking);
    } else if (wish.target && wish.arrival) {
        axis.arrive(duration, *wish.target, *wish.arrival);
    } else if (wish.target) {
        axis.follow(duration, *wish.target, wish.rate);
    } else {
        axis.run(duration, wish.rate);
    }
}

// An axis that moves in steps rounds a set-point to the nearest step, which must not be beyond the end of the range. A
// range without a step stays as it is.
TravelRange onSteps(const TravelRange& range, Angle step)
{
    if (step <= Angle{}) {
        return range;
    }
    const TravelRange inner{.min = std::ceil((range.min - pointing::kRounding) / step) * step,
                            .max = std::floor((range.max + pointing::kRounding) / step) * step};
    return inner.min <= inner.max ? inner : range;
}

// The range that an axis passes from its position before a step until it stands still after the step.
TravelRange passed(Angle before, const AxisSetpoints& axis)
{
    const TravelRange rest = axis.untilRest();
    return {.min = std::min(before, rest.min), .max = std::max(before, rest.max)};
}

bool within(const TravelRange& inner, const TravelRange& outer)
{
    return inner.min >= outer.min - pointing::kRounding && inner.max <= outer.max + pointing::kRounding;
}

TravelRange widened(const TravelRange& range, Angle by, const TravelRange& within)
{
    return {.min = std::max(range.min - by, within.min), .max = std::min(range.max + by, within.max)};
}

TravelRange with(const TravelRange& range, Angle place)
{
    return {.min = std::min(range.min, place), .max = std::max(range.max, place)};
}

int wayOf(const AxisWish& wish, Angle place)
{
    const double way = wish.target ? (*wish.target - place) / kAtEdge : wish.rate.degrees();
    const double least = wish.target ? 1.0 : 0.0;
    return way > least ? 1 : way < -least ? -1 : 0;
}

// The direction in which the axis wants to move but can not, because its room ends there.
int heldWay(const AxisWish& wish, Angle place, const TravelRange& room)
{
    const int way = wayOf(wish, place);
    const Angle left = way > 0 ? room.max - place : place - room.min;
    return left < kAtEdge ? way : 0;
}

}  // namespace

GuardedAxes::GuardedAxes(const profile::Profile& profile, const Capabilities& capabilities)
    : m_capabilities(capabilities),
      m_travel{.azimuth = travelOf(Axis::Azimuth, profile), .elevation = travelOf(Axis::Elevation, profile)},
      m_region(reachable(profile.limits), m_travel.azimuth, m_travel.elevation,
               pointing::PointingModel(profile.pointing)),
      m_azimuth(profileOf(profile.azimuth, m_travel.azimuth)),
      m_elevation(profileOf(profile.elevation, m_travel.elevation)),
      m_trial{m_azimuth, m_elevation}
{}

TravelRange GuardedAxes::travelOf(Axis axis, const profile::Profile& profile) const
{
    const auto& can = m_capabilities.axes[index(axis)];
    return can ? onSteps(profile.axis(axis).geometry.travel, can->step) : pointing::kMissingAxisTravel;
}

pointing::Region GuardedAxes::reachable(pointing::Region region) const
{
    for (const Axis axis : kAxes) {
        if (const auto& can = m_capabilities.axes[index(axis)]) {
            TravelRange& limits = axis == Axis::Azimuth ? region.azimuth : region.elevation;
            limits = onSteps(limits, can->step);
        } else {
            region = pointing::withoutAxis(std::move(region), axis);
        }
    }
    return region;
}

void GuardedAxes::start(Axis axis, Angle measured)
{
    (axis == Axis::Azimuth ? m_azimuth : m_elevation).reset(measured);
    m_ends[index(axis)].forget();
    m_swept.reset();
    m_leaves = false;
    m_settles = m_settles && !startsSeldom();
    m_aimed = false;
}

void GuardedAxes::setRegion(const pointing::Region& region, const pointing::PointingModel& pointing)
{
    m_region = pointing::PermittedRegion(reachable(region), m_travel.azimuth, m_travel.elevation, pointing);
    m_swept.reset();
}

void GuardedAxes::setLimits(Axis axis, const tracking::MotionLimits& limits)
{
    (axis == Axis::Azimuth ? m_azimuth : m_elevation).setLimits(limits);
}

void GuardedAxes::enforce(bool enforced)
{
    m_enforced = enforced;
}

bool GuardedAxes::isAnyClosed() const
{
    return std::ranges::any_of(m_ends, &AxisEnds::isAnyClosed);
}

bool GuardedAxes::lagsTowards(Axis axis, bool isUpper) const
{
    const Angle way = lags(axis) ? setpoint(axis).position - *m_sights[index(axis)].place : Angle{};
    return isUpper ? way > Angle{} : way < Angle{};
}

bool GuardedAxes::goesInto(Axis axis, bool isUpper) const
{
    const AngularRate rate = setpoint(axis).rate;
    return (isUpper ? rate > AngularRate{} : rate < AngularRate{}) || m_held[index(axis)] == (isUpper ? 1 : -1) ||
           lagsTowards(axis, isUpper);
}

// A rotator that moves by itself is still on its way to set-points beyond the place where a switch closed the end.
bool GuardedAxes::runsIntoClosed() const
{
    return std::ranges::any_of(kAxes, [this](Axis axis) {
        const AxisEnds& ends = m_ends[index(axis)];
        return (ends.isClosed(false) && lagsTowards(axis, false)) || (ends.isClosed(true) && lagsTowards(axis, true));
    });
}

AxisBox GuardedAxes::untilRest() const
{
    return {.azimuth = m_azimuth.untilRest(), .elevation = m_elevation.untilRest()};
}

void GuardedAxes::setSeen(const std::optional<AxisPosition>& place)
{
    m_sights[0].place = place ? std::optional(place->azimuth) : std::nullopt;
    m_sights[1].place = place ? std::optional(place->elevation) : std::nullopt;
}

void GuardedAxes::watch(Seconds duration)
{
    for (const Axis axis : kAxes) {
        Sight& sight = m_sights[index(axis)];
        sight.time += duration;
        if (!sight.place || !m_capabilities.lags(axis)) {
            continue;
        }
        const AxisCapabilities& can = *m_capabilities.axes[index(axis)];
        if (abs(*sight.place - sight.stood) > std::max(can.step, 0.5 * can.miss)) {  // smaller changes are noise
            sight.stood = *sight.place;
            sight.time = Seconds(0.0);
        }
    }
}

// A moving axis is nearly at its set-point. A standing axis may have missed it, and comes no nearer.
bool GuardedAxes::lags(Axis axis) const
{
    const Sight& sight = m_sights[index(axis)];
    if (!sight.place || !m_capabilities.lags(axis)) {
        return false;
    }
    const Angle nearly = m_capabilities.axes[index(axis)]->step + kNearly;
    const Angle most = sight.time < kStands ? nearly : std::max(nearly, m_capabilities.inexactness(axis));
    return abs(*sight.place - setpoint(axis).position) > most;
}

// Adds the range that a lagging rotator still has to pass.
AxisBox GuardedAxes::fromSeen(AxisBox box) const
{
    for (const Axis axis : kAxes) {
        TravelRange& range = axis == Axis::Azimuth ? box.azimuth : box.elevation;
        range = lags(axis) ? with(range, *m_sights[index(axis)].place) : range;
    }
    return box;
}

// True if no motion is wanted any more and the set-points stand still, but a slow rotator is still on its way there.
// This ends once the rotator has arrived. If wind pushes it away later, its driver sends it back. An axis whose motor
// starts seldom may stand beside its set-point, or run past it. So after each target it is taken over again where it
// is, and a hold or a jog of the other axis does not start its motor.
bool GuardedAxes::runsAfter(const AxisWish& azimuth, const AxisWish& elevation)
{
    const auto isNothing = [](const AxisWish& wish) { return !wish.target && wish.rate == AngularRate{}; };
    const bool hasTarget = azimuth.target || elevation.target;
    m_aimed = m_aimed || hasTarget;
    if (!isNothing(azimuth) || !isNothing(elevation)) {
        m_settles = true;
        return startsSeldom() && m_aimed && !hasTarget;
    }
    if (startsSeldom()) {
        return m_settles;  // until start()
    }
    const bool isFar = std::ranges::any_of(kAxes, [this](Axis axis) {
        return lags(axis) && abs(*m_sights[index(axis)].place - setpoint(axis).position) > kRunsAfter;
    });
    m_settles = m_settles && (isFar || !atRest());
    return m_settles && atRest();
}

bool GuardedAxes::startsSeldom() const
{
    return std::ranges::any_of(kAxes, [this](Axis axis) { return m_capabilities.startsSeldom(axis); });
}

bool GuardedAxes::strays() const
{
    const bool edgeMoved = !m_swept && !m_leaves;
    return std::ranges::any_of(kAxes, [&](Axis axis) {
        return lags(axis) && (edgeMoved || (atRest() && m_sights[index(axis)].time >= kLeftBehind));
    });
}

void GuardedAxes::step(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation)
{
    watch(duration);
    m_ends[0].keep(m_azimuth.untilRest());
    m_ends[1].keep(m_elevation.untilRest());
    stepGuarded(duration, m_capabilities.has(Axis::Azimuth) ? azimuth : AxisWish{},
                m_capabilities.has(Axis::Elevation) ? elevation : AxisWish{});
}

void GuardedAxes::stepGuarded(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation)
{
    const bool isFree = !m_enforced || m_region.permits(fromSeen(untilRest()));
    const bool isLate = runsAfter(azimuth, elevation);
    m_stray = isLate || (!isFree && strays()) || runsIntoClosed();
    if (!m_enforced) {
        stepFree(duration, azimuth, elevation);
    } else if (isFree) {
        stepInside(duration, azimuth, elevation);
    } else if (m_swept || m_region.permits(place())) {
        // An edge was moved into the way, limits of motion were lowered, or the rotator lags behind. The axes brake
        // within the room that was permitted before.
        m_held = {wayOf(azimuth, place().azimuth), wayOf(elevation, place().elevation)};
        brake(duration, m_swept.value_or(m_travel), azimuth, elevation);
    } else {
        stepOut(duration, azimuth, elevation);
    }
}

void GuardedAxes::stepFree(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation)
{
    m_swept.reset();
    m_leaves = false;
    const TravelRange azimuths = openPart(Axis::Azimuth, m_travel.azimuth);
    const TravelRange elevations = openPart(Axis::Elevation, m_travel.elevation);
    m_azimuth.setTravel(azimuths);
    m_elevation.setTravel(elevations);
    obey(m_azimuth, duration, azimuth);
    obey(m_elevation, duration, elevation);
    m_held = {heldWay(azimuth, place().azimuth, azimuths), heldWay(elevation, place().elevation, elevations)};
}

// First the azimuth moves in the room that is free for all elevations until the elevation stops. Then the elevation
// moves in the room that is free for all azimuths until the azimuth stops. Both moves are a trial: the whole range that
// they would pass must be permitted.
void GuardedAxes::stepInside(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation)
{
    const AxisPosition before = place();
    AxisBox box = fromSeen(untilRest());
    auto& [nextAzimuth, nextElevation] = m_trial;
    nextAzimuth = m_azimuth;
    nextElevation = m_elevation;
    const TravelRange azimuths = openPart(Axis::Azimuth, m_region.azimuthsAround(box));
    nextAzimuth.setTravel(azimuths);
    obey(nextAzimuth, duration, azimuth);
    const AxisBox still = std::exchange(box, fromSeen({passed(before.azimuth, nextAzimuth), box.elevation}));
    const TravelRange elevations = openPart(Axis::Elevation, m_region.elevationsAround(box));
    nextElevation.setTravel(elevations);
    obey(nextElevation, duration, elevation);
    box = fromSeen({box.azimuth, passed(before.elevation, nextElevation)});
    if (!m_region.permits(box)) {
        m_swept = still;
        m_held = {wayOf(azimuth, before.azimuth), wayOf(elevation, before.elevation)};
        brake(duration, still, azimuth, elevation);
        return;
    }
    std::swap(m_azimuth, nextAzimuth);
    std::swap(m_elevation, nextElevation);
    m_swept = fromSeen(untilRest());
    m_leaves = false;
    m_held = {heldWay(azimuth, place().azimuth, azimuths), heldWay(elevation, place().elevation, elevations)};
}

// Each axis moves only from its stopping position towards the nearest permitted place. An axis that moves in another
// direction brakes first.
void GuardedAxes::stepOut(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation)
{
    m_leaves = true;
    const AxisPosition out = pointing::nearestPermitted(m_region, place()).value_or(place());
    const AxisBox room = AxisBox::between(place(), out);
    const auto move = [&](Axis which, const TravelRange& free, Angle end, const AxisWish& wish) {
        AxisSetpoints& axis = which == Axis::Azimuth ? m_azimuth : m_elevation;
        const TravelRange rest = axis.untilRest();
        const bool inside = within(rest, free);
        const TravelRange way = end == free.max ? TravelRange{rest.max, end} : TravelRange{end, rest.min};
        axis.setTravel(inside ? openPart(which, way) : which == Axis::Azimuth ? m_travel.azimuth : m_travel.elevation);
        obey(axis, duration, inside ? wish : AxisWish{.braking = wish.braking});
    };
    move(Axis::Azimuth, room.azimuth, out.azimuth, azimuth);
    move(Axis::Elevation, room.elevation, out.elevation, elevation);
    m_held = {heldWay(azimuth, place().azimuth, room.azimuth), heldWay(elevation, place().elevation, room.elevation)};
}

void GuardedAxes::brake(Seconds duration, const AxisBox& within, const AxisWish& azimuth, const AxisWish& elevation)
{
    m_azimuth.setTravel(within.azimuth);
    m_elevation.setTravel(within.elevation);
    obey(m_azimuth, duration, {.braking = azimuth.braking});
    obey(m_elevation, duration, {.braking = elevation.braking});
}

const tracking::Setpoint& GuardedAxes::setpoint(Axis axis) const
{
    return (axis == Axis::Azimuth ? m_azimuth : m_elevation).setpoint();
}

Angle GuardedAxes::restOf(Axis axis) const
{
    const tracking::AxisSetpoints& profile = axis == Axis::Azimuth ? m_azimuth : m_elevation;
    const TravelRange range = profile.untilRest();
    const tracking::Setpoint& here = profile.setpoint();
    const double way = here.rate != AngularRate{} ? here.rate.degrees() : here.acceleration.degrees();
    return way > 0.0 ? range.max : way < 0.0 ? range.min : here.position;
}

GuardedAxes::Surroundings GuardedAxes::surroundings(const AxisPosition& room) const
{
    if (!m_enforced) {
        return {.box = m_travel, .free = true};
    }
    AxisBox box = fromSeen(untilRest());
    if (!m_region.permits(box) || isAnyClosed()) {
        return {.box = box};
    }
    const auto around = [&](Axis axis, const TravelRange& range, Angle by, const TravelRange& within) {
        return widened(with(range, m_sights[index(axis)].place.value_or(range.min)), by, within);
    };
    const AxisBox& ranges = m_region.ranges();
    const AxisBox wide{.azimuth = around(Axis::Azimuth, box.azimuth, room.azimuth, ranges.azimuth),
                       .elevation = around(Axis::Elevation, box.elevation, room.elevation, ranges.elevation)};
    const bool isSeenInside = std::ranges::all_of(kAxes, [&](Axis axis) {
        const std::optional<Angle>& seen = m_sights[index(axis)].place;
        const TravelRange& range = axis == Axis::Azimuth ? ranges.azimuth : ranges.elevation;
        return !seen || with(range, *seen) == range;
    });
    if (isSeenInside && m_region.permits(wide)) {
        return {.box = wide, .free = true};
    }
    const auto step = [this](Axis axis) {
        return m_capabilities.has(axis) ? m_capabilities.axes[index(axis)]->step : Angle{};
    };
    box.azimuth = widened(box.azimuth, step(Axis::Azimuth), m_region.azimuthsAround(box));
    box.elevation = widened(box.elevation, step(Axis::Elevation), m_region.elevationsAround(box));
    return {.box = box};
}

AxisPosition GuardedAxes::place() const
{
    return {.azimuth = m_azimuth.setpoint().position, .elevation = m_elevation.setpoint().position};
}

bool GuardedAxes::atRest() const
{
    return m_azimuth.atRest() && m_elevation.atRest();
}

Seconds GuardedAxes::restTime(const AxisPosition& target) const
{
    return std::max(m_azimuth.restTime(target.azimuth), m_elevation.restTime(target.elevation));
}

QString GuardedAxes::obstacle() const
{
    const AxisPosition here = place();
    // The rotator may still have to pass there.
    const AxisPosition seen{.azimuth = m_sights[0].place.value_or(here.azimuth),
                            .elevation = m_sights[1].place.value_or(here.elevation)};
    const Angle azimuth = m_held[0] * kBeyondEdge;
    const Angle elevation = m_held[1] * kBeyondEdge;
    for (const AxisPosition& beyond : {here, AxisPosition{here.azimuth + azimuth, here.elevation},
                                       AxisPosition{here.azimuth, here.elevation + elevation},
                                       AxisPosition{here.azimuth + azimuth, here.elevation + elevation},
                                       AxisPosition{here.azimuth + azimuth, seen.elevation},
                                       AxisPosition{seen.azimuth, here.elevation + elevation}}) {
        if (QString what = m_region.obstacle(beyond); !what.isEmpty()) {
            return what;
        }
    }
    return {};
}

}  // namespace boresight
