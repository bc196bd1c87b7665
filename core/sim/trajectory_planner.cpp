// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/trajectory_planner.h"

#include <algorithm>
#include <cmath>

namespace boresight::sim {
namespace {

// The speed towards a fixed point `distance` ahead that, held as a mean with the present `speed` over one step, still
// leaves exactly the braking distance: the root of v²/2a = distance - (speed + v)·dt/2. No root: too late to stop.
std::optional<double> brakingSpeed(double distance, double speed, double acceleration, double dt)
{
    const double root = 0.25 * dt * dt + (2.0 * distance - speed * dt) / acceleration;
    if (root < 0.0) {
        return std::nullopt;
    }
    return acceleration * (std::sqrt(root) - 0.5 * dt);
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
    m_target.velocity = clampedTargetVelocity(limits);
    if (m_target.position) {
        *m_target.position += m_target.velocity * dt;
    }
    const double before = m_state.velocity;
    if (std::isinf(limits.acceleration)) {
        stepWithoutAccelerationLimit(dt, limits);
        m_state.acceleration = 0.0;
    } else {
        m_target.position ? stepToPosition(dt, limits) : stepToVelocity(dt, limits);
        m_state.acceleration = (m_state.velocity - before) / dt;
    }
    clampTo(bounds);
}

void TrajectoryPlanner::shift(double offset)
{
    m_state.position += offset;
    if (m_target.position) {
        *m_target.position += offset;
    }
}

double TrajectoryPlanner::clampedTargetVelocity(const TrajectoryLimits& limits) const
{
    return std::clamp(m_target.velocity, -limits.velocity, limits.velocity);
}

// Velocity steps at once; without a velocity limit either the position jumps.
void TrajectoryPlanner::stepWithoutAccelerationLimit(double dt, const TrajectoryLimits& limits)
{
    if (!m_target.position) {
        m_state.velocity = m_target.velocity;
        m_state.position += m_state.velocity * dt;
        m_state.complete = true;
        return;
    }
    const double distance = *m_target.position - m_state.position;
    if (std::abs(distance) > limits.velocity * dt) {
        m_state.velocity = std::copysign(limits.velocity, distance);
        m_state.position += m_state.velocity * dt;
        return;
    }
    m_state.position = *m_target.position;
    m_state.velocity = m_target.velocity;
    m_state.complete = true;
}

void TrajectoryPlanner::stepToVelocity(double dt, const TrajectoryLimits& limits)
{
    const double before = m_state.velocity;
    const double change = limits.acceleration * dt;
    m_state.velocity = std::clamp(m_target.velocity, before - change, before + change);
    m_state.position += 0.5 * (before + m_state.velocity) * dt;
    m_state.complete = m_state.velocity == m_target.velocity;
}

// In the frame that moves with the target and points to it, the task is always: stop at `distance` ahead.
void TrajectoryPlanner::stepToPosition(double dt, const TrajectoryLimits& limits)
{
    const double targetBefore = *m_target.position - m_target.velocity * dt;
    const double separation = targetBefore - m_state.position;
    const double direction = separation < 0.0 ? -1.0 : 1.0;
    const double distance = std::abs(separation);
    const double speed = direction * (m_state.velocity - m_target.velocity);
    const double change = limits.acceleration * dt;

    // Close enough that one step ends it: within what the acceleration covers in one step.
    if (std::abs(speed) <= change && distance <= change * dt) {
        m_state.position = *m_target.position;
        m_state.velocity = m_target.velocity;
        m_state.complete = true;
        return;
    }
    const double fastest = limits.velocity - direction * m_target.velocity;
    double next = brakingSpeed(distance, speed, limits.acceleration, dt).value_or(speed - change);
    next = std::min(next, fastest);  // slowing down to a lowered limit takes its time, below
    next = std::clamp(next, speed - change, speed + change);
    m_state.complete = false;
    m_state.velocity = m_target.velocity + direction * next;
    m_state.position = *m_target.position - direction * (distance - 0.5 * (speed + next) * dt);
}

void TrajectoryPlanner::clampTo(const PositionBounds& bounds)
{
    const double clamped = std::min(std::max(m_state.position, bounds.min), bounds.max);
    if (clamped == m_state.position) {
        return;
    }
    m_state.position = clamped;
    m_state.velocity = 0.0;
    m_state.acceleration = 0.0;
    m_state.complete = false;
}

}  // namespace boresight::sim
