// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/trajectory_planner.h"

#include <algorithm>
#include <cmath>

namespace boresight::sim {
namespace {

constexpr double kPeriodsPerSecond = 30000.0;
constexpr double kControlPeriod = 1.0 / kPeriodsPerSecond;
constexpr double kRoundingOfSums = 1.0e-6;  // periods

// The device rounds the distance to a target down to counts. It moves in steps of 2^-32 turns, truncated towards zero.
constexpr double kCountsOfPlanner = 65536.0;
constexpr double kStepsOfPlanner = 65536.0 * 65536.0;

// The target is reached within this many periods of travel.
constexpr double kPeriodsToArrive = 10.0;
// If stopping at the target needs at least this share of the acceleration limit, the device brakes with just that
// acceleration.
constexpr double kFittedShare = 0.9;
// Within a·T² times kNearFactor a moving axis does not accelerate any more. Within this distance it has arrived when it
// brakes and is slower than kSlowShare times the speed from which the limit would stop it at the target.
constexpr double kNearFactor = 400.0;
constexpr double kSlowShare = 0.6;

double travelOfPeriod(double velocity)
{
    return std::trunc(velocity * kControlPeriod * kStepsOfPlanner) / kStepsOfPlanner;
}

// The braking for a fixed target that is `way` ahead, at `speed`. Empty if there is room to accelerate.
std::optional<double> brakingFor(double way, double speed, double limit)
{
    const double fitted = speed * speed / (2.0 * way);
    const double faster = speed + limit * kControlPeriod;
    const double wayAfter = way - 0.5 * (speed + faster) * kControlPeriod;
    if (wayAfter < faster * faster / (2.0 * limit)) {
        return fitted >= kFittedShare * limit && fitted <= limit ? fitted : limit;
    }
    const bool near = way < kNearFactor * limit * kControlPeriod * kControlPeriod;
    return near && speed > 0.0 ? std::optional(fitted) : std::nullopt;
}

// The acceleration of one period at `velocity`, for a target that is `distance` ahead and moves at `end`.
double plannedAcceleration(double velocity, double end, double distance, const TrajectoryLimits& limits)
{
    const double limit = limits.acceleration;
    if (std::abs(velocity) > limits.velocity) {
        return std::copysign(limit, -velocity);
    }
    const double closing = velocity - end;
    if (distance == 0.0 || closing * distance < 0.0) {
        return std::copysign(limit, -closing);
    }
    if (const auto braking = brakingFor(std::abs(distance), std::abs(closing), limit)) {
        return std::copysign(*braking, -closing);
    }
    return std::abs(velocity) < limits.velocity ? std::copysign(limit, distance) : 0.0;
}

}  // namespace

void TrajectoryPlanner::capture(double position, double velocity)
{
    m_state.position = position;
    m_state.velocity = velocity;
    m_state.acceleration = 0.0;
    m_target = {.position = std::nullopt, .velocity = velocity};
}

void TrajectoryPlanner::setTarget(const TrajectoryTarget& target, double age)
{
    m_target = target;
    if (m_target.position) {
        *m_target.position += target.velocity * age;
    }
    m_state.complete = false;
}

void TrajectoryPlanner::step(double dt, const TrajectoryLimits& limits, const PositionBounds& bounds)
{
    m_owed += dt * kPeriodsPerSecond;
    const int periods = static_cast<int>(std::floor(m_owed + kRoundingOfSums));
    m_owed -= periods;
    const double before = m_state.velocity;
    runPeriods(periods, limits);
    m_state.acceleration = std::isinf(limits.acceleration) ? 0.0 : (m_state.velocity - before) / dt;
    const double clamped = std::min(std::max(m_state.position, bounds.min), bounds.max);
    if (clamped != m_state.position) {
        m_state = {.position = clamped};
    }
}

void TrajectoryPlanner::shift(double offset)
{
    m_state.position += offset;
    if (m_target.position) {
        *m_target.position += offset;
    }
}

void TrajectoryPlanner::runPeriods(int count, const TrajectoryLimits& limits)
{
    m_target.velocity = std::clamp(m_target.velocity, -limits.velocity, limits.velocity);
    for (int left = count; left > 0; --left) {
        if (!m_target.position && m_state.velocity == m_target.velocity) {
            m_state.position += left * travelOfPeriod(m_state.velocity);
            m_state.complete = true;
            return;
        }
        runPeriod(limits);
    }
}

void TrajectoryPlanner::runPeriod(const TrajectoryLimits& limits)
{
    const double before = m_state.velocity;
    const bool ramp = std::isfinite(limits.acceleration);
    if (!m_target.position) {
        ramp ? approachVelocity(limits.acceleration) : reached();
    } else if (ramp) {
        approachTarget(limits, distance());
    } else if (std::isfinite(limits.velocity)) {
        approachAtSpeed(limits.velocity, distance());
    } else {
        m_state.position = *m_target.position;
        reached();
    }
    // If the velocity changes in one step, the new velocity counts for the whole period.
    m_state.position += travelOfPeriod(ramp ? 0.5 * (before + m_state.velocity) : m_state.velocity);
    if (m_target.position) {
        *m_target.position += travelOfPeriod(m_target.velocity);
    }
}

double TrajectoryPlanner::distance() const
{
    return std::floor((*m_target.position - m_state.position) * kCountsOfPlanner) / kCountsOfPlanner;
}

// The device drops the target position and goes on at the velocity of the target.
void TrajectoryPlanner::reached()
{
    m_target.position.reset();
    m_state.velocity = m_target.velocity;
    m_state.complete = true;
}

void TrajectoryPlanner::approachAtSpeed(double speed, double distance)
{
    m_state.velocity = distance < 0.0 ? -speed : speed;
    const double after = distance - m_state.velocity * kControlPeriod;
    if ((after < 0.0) != (distance < 0.0)) {
        reached();
    }
}

void TrajectoryPlanner::approachVelocity(double acceleration)
{
    const double change = acceleration * kControlPeriod;
    m_state.velocity = std::clamp(m_target.velocity, m_state.velocity - change, m_state.velocity + change);
    m_state.complete = m_state.velocity == m_target.velocity;
}

void TrajectoryPlanner::approachTarget(const TrajectoryLimits& limits, double distance)
{
    const double before = m_state.velocity;
    const double applied = plannedAcceleration(before, m_target.velocity, distance, limits);
    m_state.velocity += applied * kControlPeriod;
    // If the velocity would pass the limit in this period, the device runs exactly at the limit.
    if ((std::abs(before) - limits.velocity) * (std::abs(m_state.velocity) - limits.velocity) < 0.0) {
        m_state.velocity = std::copysign(limits.velocity, before);
    }
    m_state.complete = false;
    if (arrives(limits.acceleration, distance, before, applied)) {
        reached();
    }
}

bool TrajectoryPlanner::arrives(double acceleration, double distance, double before, double applied) const
{
    const double end = m_target.velocity;
    const double closing = m_state.velocity - end;
    const bool atEndVelocity =
        (before - end) * closing <= 0.0 || std::abs(closing) < 0.5 * acceleration * kControlPeriod;
    const double travel = std::max(std::abs(closing), std::abs(end)) * kPeriodsToArrive * kControlPeriod;
    if (atEndVelocity && std::abs(distance) <= travel) {
        return true;
    }
    const bool near = std::abs(distance) < kNearFactor * acceleration * kControlPeriod * kControlPeriod;
    const bool slow = std::abs(closing) < kSlowShare * std::sqrt(2.0 * acceleration * std::abs(distance));
    return near && slow && distance * closing > 0.0 && applied * closing < 0.0;
}

}  // namespace boresight::sim
