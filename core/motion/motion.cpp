// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/motion.h"

#include "core/pointing/nearest_permitted.h"
#include "core/pointing/route.h"
#include "core/tracking/emergency_braking.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

using pointing::AxisBox;

// A way is planned again no more often than this, and not for a target that has hardly moved.
constexpr std::chrono::milliseconds kPlanPause{250};
constexpr Angle kSameEnd = Angle::fromDegrees(0.5);

// Behind a keep-out both of its sides can be equally near. The other side is used only if it is nearer by this much.
constexpr Angle kSidePreference = Angle::fromDegrees(1.0);

// A motor without speed control is faster than set-points that still speed up. It is switched on this late, so that it
// does not stop on the way.
constexpr Seconds kGather{0.9};
constexpr Angle kMostGathered = Angle::fromDegrees(6.0);
// A jog starts it at once. It must not arrive before the set-points have sped up.
constexpr Seconds kJogLead{1.5};
constexpr Angle kMostJogLead = Angle::fromDegrees(9.0);
constexpr double kStepsOfJogLead = 1.4;
constexpr double kOfJogLead = 0.8;  // a motor starts when this share of the lead is missing
// Set-points that are nearer than this to a moving target follow it.
constexpr Angle kFollows = Angle::fromDegrees(1.0);
// The lead covers this time of the motion. A slow target needs less lead, because its motor starts seldom anyway.
constexpr Seconds kLeadTime{20.0};

Angle distance(const AxisPosition& a, const AxisPosition& b)
{
    const double width = std::cos(a.elevation.radians());
    return Angle::fromRadians(
        std::hypot(width * (b.azimuth - a.azimuth).radians(), (b.elevation - a.elevation).radians()));
}

bool same(const AxisPosition& a, const AxisPosition& b)
{
    return abs(a.azimuth - b.azimuth) < kSameEnd && abs(a.elevation - b.elevation) < kSameEnd;
}

}  // namespace

Motion::Motion(const profile::Profile& profile, const Capabilities& capabilities)
    : m_capabilities(capabilities), m_axes(profile, capabilities), m_arrival(profile.control.arrival)
{
    for (const Axis axis : kAxes) {
        setLimits(axis, profile.axis(axis).limits);
    }
}

void Motion::start(Axis axis, Angle measured)
{
    m_axes.start(axis, measured);
    m_way = {};
}

void Motion::rest()
{
    m_wanted = Resting{};
    forgetWay();
}

void Motion::goTo(const AxisPosition& place)
{
    m_wanted = place;
    forgetWay();
}

void Motion::follow(const AxisPosition& point, SteadyTime now)
{
    if (auto* const stream = std::get_if<tracking::TargetStream>(&m_wanted)) {
        stream->add(now, point);
        return;
    }
    m_wanted.emplace<tracking::TargetStream>().restart(now, point);
    forgetWay();
}

void Motion::confirmStream(SteadyTime now)
{
    if (auto* const stream = std::get_if<tracking::TargetStream>(&m_wanted)) {
        stream->confirm(now);
    }
}

void Motion::settleStream()
{
    if (const auto* const stream = std::get_if<tracking::TargetStream>(&m_wanted)) {
        if (const auto last = stream->lastPoint()) {
            m_wanted = AxisPosition{last->azimuth + m_trim.azimuth, last->elevation + m_trim.elevation};
        }
    }
}

void Motion::keepOn(SteadyTime now)
{
    if (std::holds_alternative<tracking::TargetStream>(m_wanted)) {
        if (const auto target = movingTarget(now)) {
            m_wanted = Straight{.target = *target, .since = now};
        }
    }
}

void Motion::lead(const AxisPosition& place, const AxisRates& rates, SteadyTime now)
{
    if (!std::holds_alternative<Straight>(m_wanted)) {
        forgetWay();
    }
    const AxisPosition trimmed{.azimuth = place.azimuth + m_trim.azimuth,
                               .elevation = place.elevation + m_trim.elevation};
    const bool isMoving = rates != AxisRates{};
    m_wanted = Straight{.target = {.position = trimmed, .rates = rates, .streaming = isMoving},
                        .since = now,
                        .pauses = !isMoving && pausesAt(trimmed)};
}

// The target moved until this call, and stands where the set-points stop.
bool Motion::pausesAt(const AxisPosition& place) const
{
    const auto* const last = std::get_if<Straight>(&m_wanted);
    if (!last || (!last->pauses && !last->target.streaming)) {
        return false;
    }
    const AxisPosition stop = last->pauses ? last->target.position
                                           : AxisPosition{m_axes.restOf(Axis::Azimuth), m_axes.restOf(Axis::Elevation)};
    const bool isNear = abs(stop.elevation - place.elevation) < kSameEnd || !m_capabilities.has(Axis::Elevation);
    return isNear && (abs(stop.azimuth - place.azimuth) < kSameEnd || !m_capabilities.has(Axis::Azimuth));
}

bool Motion::pauses() const
{
    const auto* const straight = std::get_if<Straight>(&m_wanted);
    return straight && straight->pauses;
}

void Motion::run(const AxisRates& rates)
{
    m_wanted = rates;
    forgetWay();
}

void Motion::setRegion(const pointing::Region& region, const pointing::PointingModel& pointing)
{
    m_axes.setRegion(region, pointing);
    forgetWay();
}

void Motion::setLimits(Axis axis, const tracking::MotionLimits& limits)
{
    const auto& can = m_capabilities.axes[index(axis)];
    tracking::MotionLimits& known = m_limits[index(axis)];
    known = limits;
    known.speed = can && can->fastest ? std::min(limits.speed, *can->fastest) : limits.speed;
    m_axes.setLimits(axis, known);
    m_hardest[index(axis)] = tracking::emergencyBraking(known);
}

void Motion::setTrim(const AxisPosition& trim)
{
    m_trim = {.azimuth = m_capabilities.has(Axis::Azimuth) ? trim.azimuth : Angle{},
              .elevation = m_capabilities.has(Axis::Elevation) ? trim.elevation : Angle{}};
}

void Motion::forgetWay()
{
    m_way = {};
    m_limited.reset();
}

std::optional<tracking::MovingTarget> Motion::movingTarget(SteadyTime now) const
{
    if (const auto* const place = std::get_if<AxisPosition>(&m_wanted)) {
        return tracking::MovingTarget{.position = *place, .rates = {}, .streaming = false};
    }
    if (const auto* const straight = std::get_if<Straight>(&m_wanted)) {
        tracking::MovingTarget target = straight->target;
        const Seconds time = now - straight->since;
        target.position = {target.position.azimuth + target.rates.azimuth * time,
                           target.position.elevation + target.rates.elevation * time};
        return target;
    }
    if (const auto* const stream = std::get_if<tracking::TargetStream>(&m_wanted)) {
        auto target = stream->target(now);
        if (target) {
            target->position = {target->position.azimuth + m_trim.azimuth,
                                target->position.elevation + m_trim.elevation};
        }
        return target;
    }
    return std::nullopt;
}

std::optional<tracking::StreamError> Motion::streamError(SteadyTime now) const
{
    const auto* const stream = std::get_if<tracking::TargetStream>(&m_wanted);
    return stream != nullptr ? stream->error(now) : std::nullopt;
}

void Motion::advance(SteadyTime now, Seconds step)
{
    if (const auto target = movingTarget(now)) {
        driveTo(*target, now, step);
    } else if (const auto* const rates = std::get_if<AxisRates>(&m_wanted)) {
        m_axes.step(step, {.rate = rates->azimuth}, {.rate = rates->elevation});
    } else {
        brake(step);
    }
}

// Behind a keep-out the nearest permitted place can jump from one side to the other. It stays on one side until the
// other side is clearly nearer.
std::optional<tracking::MovingTarget> Motion::permitted(const tracking::MovingTarget& target)
{
    if (!m_axes.enforced() || region().permits(target.position)) {
        m_limited.reset();
        return target;
    }
    auto nearest = pointing::nearestPermitted(region(), target.position);
    if (nearest && m_limited && !region().permits(AxisBox::between(*nearest, m_limited->nearest)) &&
        distance(target.position, m_limited->nearest) < distance(target.position, *nearest) + kSidePreference) {
        nearest = m_limited->nearest;
    }
    if (!nearest) {
        m_limited.reset();
        return std::nullopt;
    }
    m_limited = {.target = target.position, .nearest = *nearest};
    return tracking::MovingTarget{.position = *nearest, .rates = {}, .streaming = target.streaming};
}

void Motion::driveTo(const tracking::MovingTarget& target, SteadyTime now, Seconds step)
{
    const auto goal = permitted(target);
    if (!goal) {
        m_way.obstacle = region().reason(target.position);
        brake(step);
        return;
    }
    if (!m_axes.enforced() || region().permits(AxisBox::between(place(), goal->position))) {
        m_way = {};
        stepTo(*goal, step);
        return;
    }
    planTo(goal->position, now);
    if (m_way.legs.empty()) {
        brake(step);
        return;
    }
    while (m_way.legs.size() > 1 && region().permits(AxisBox::between(place(), m_way.legs[1]))) {
        m_way.legs.erase(m_way.legs.begin());
    }
    m_axes.step(step, {.target = m_way.legs.front().azimuth}, {.target = m_way.legs.front().elevation});
}

void Motion::stepTo(const tracking::MovingTarget& goal, Seconds step)
{
    const bool together = m_arrival == profile::Arrival::Together && !goal.streaming && goal.rates == AxisRates{};
    const auto arrival = together ? std::optional(m_axes.restTime(goal.position)) : std::nullopt;
    m_axes.step(step, {.target = goal.position.azimuth, .rate = goal.rates.azimuth, .arrival = arrival},
                {.target = goal.position.elevation, .rate = goal.rates.elevation, .arrival = arrival});
}

// The old way stays while its end stays and its next leg is free. Between two plans GuardedAxes ensures that nothing
// forbidden is entered.
void Motion::planTo(const AxisPosition& end, SteadyTime now)
{
    const bool holds = m_way.end && same(*m_way.end, end) && !m_way.legs.empty() &&
                       region().permits(AxisBox::between(place(), m_way.legs.front()));
    if (holds || (m_way.end && now - m_way.planned < kPlanPause)) {
        return;
    }
    m_way = {.end = end, .planned = now};
    if (auto legs = route(place(), end)) {
        m_way.legs = std::move(*legs);
    } else {
        m_way.obstacle = legs.error().text;
    }
}

Result<std::vector<AxisPosition>> Motion::route(const AxisPosition& from, const AxisPosition& to) const
{
    if (!m_axes.enforced()) {
        return std::vector{to};
    }
    return pointing::route(region(), from, to, {.azimuth = m_limits[0].speed, .elevation = m_limits[1].speed});
}

void Motion::brake(Seconds step)
{
    const auto braking = [this](std::size_t axis) {
        return AxisWish{.braking = m_hardBraking ? std::optional(m_hardest[axis]) : std::nullopt};
    };
    m_axes.step(step, braking(0), braking(1));
}

std::optional<AxisPosition> Motion::target(SteadyTime now) const
{
    if (m_limited) {
        return m_limited->nearest;
    }
    const auto target = movingTarget(now);
    return target ? std::optional(target->position) : std::nullopt;
}

bool Motion::streaming(SteadyTime now) const
{
    const auto target = movingTarget(now);
    return target && target->streaming;
}

std::optional<tracking::MovingTarget> Motion::path(SteadyTime now) const
{
    const auto target = movingTarget(now);
    return target && target->streaming ? target : std::nullopt;
}

bool Motion::follows(SteadyTime now) const
{
    const auto target = pauses() ? movingTarget(now) : path(now);
    return target && abs(target->position.azimuth - place().azimuth) < kFollows &&
           abs(target->position.elevation - place().elevation) < kFollows;
}

// The motor of a jog starts with the key, and stops with it. The lead is at least a step, wherever between two steps
// the set-point is.
Angle Motion::jogLead(Axis axis) const
{
    const auto* const rates = std::get_if<AxisRates>(&m_wanted);
    const AngularRate rate = !rates ? AngularRate{} : axis == Axis::Azimuth ? rates->azimuth : rates->elevation;
    if (rate == AngularRate{} || !m_capabilities.startsSeldom(axis)) {
        return {};
    }
    const Angle least = kStepsOfJogLead * m_capabilities.axes[index(axis)]->step;
    const Angle lead = std::clamp(abs(rate) * kJogLead, least, std::max(least, kMostJogLead));
    return rate < AngularRate{} ? -lead : lead;
}

Angle Motion::band(Axis axis, SteadyTime now) const
{
    const bool isWide = m_band && m_capabilities.startsSeldom(axis) && follows(now);
    return isWide ? std::max(m_band->width, m_capabilities.axes[index(axis)]->step) : Angle{};
}

// While the set-point stands still, the axis has to be there, except while tracking pauses.
Angle Motion::slack(Axis axis, SteadyTime now) const
{
    const tracking::Setpoint& here = setpoint(axis);
    const bool stands = here.rate == AngularRate{} && here.acceleration == AngularAcceleration{};
    if (!m_capabilities.startsSeldom(axis) || !m_band || (stands && !pauses())) {
        return {};
    }
    if (std::holds_alternative<AxisRates>(m_wanted)) {
        return kOfJogLead * abs(jogLead(axis));
    }
    if (follows(now)) {
        return band(axis, now);
    }
    const auto end = target(now);
    const Angle left = end ? abs((axis == Axis::Azimuth ? end->azimuth : end->elevation) - here.position) : Angle{};
    const Angle gathered = std::min(m_limits[index(axis)].speed * kGather, kMostGathered);
    return left > gathered ? gathered : Angle{};
}

std::array<tracking::Leeway, 2> Motion::leeway(SteadyTime now) const
{
    std::array<tracking::Leeway, 2> all{};
    if (!m_capabilities.hasSteps(Axis::Azimuth) && !m_capabilities.hasSteps(Axis::Elevation)) {
        return all;
    }
    AxisPosition room;
    for (const Axis axis : kAxes) {
        tracking::Leeway& one = all[index(axis)];
        one.rest = m_axes.restOf(axis);
        one.band = slack(axis, now);
        one.lead = one.band > Angle{} ? jogLead(axis) : Angle{};
        if (one.band > Angle{} && follows(now)) {
            const Angle lead = setpoint(axis).rate * kLeadTime;
            one.lead = std::clamp(lead, -one.band, one.band);
            one.follows = true;
            one.halfBeam = m_band->halfBeam;
        }
        const Angle step = m_capabilities.has(axis) ? m_capabilities.axes[index(axis)]->step : Angle{};
        (axis == Axis::Azimuth ? room.azimuth : room.elevation) = one.band + abs(one.lead) + step;
    }
    const GuardedAxes::Surroundings around = m_axes.surroundings(room);
    for (const Axis axis : kAxes) {
        tracking::Leeway& one = all[index(axis)];
        one.within = axis == Axis::Azimuth ? around.box.azimuth : around.box.elevation;
        if (!around.free) {
            one.band = one.lead = one.halfBeam = Angle{};
            one.follows = false;
        }
    }
    return all;
}

bool Motion::limited(Axis axis) const
{
    if (!m_limited) {
        return false;
    }
    const auto& [target, nearest] = *m_limited;
    return axis == Axis::Azimuth ? target.azimuth != nearest.azimuth : target.elevation != nearest.elevation;
}

QString Motion::obstacle() const
{
    return m_limited ? region().obstacle(m_limited->target) : m_axes.obstacle();
}

}  // namespace boresight
