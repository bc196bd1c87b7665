// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/axis_setpoints.h"

#include <algorithm>
#include <cmath>

namespace boresight::tracking {

namespace {

// rad: below the resolution of any encoder (6e-11°) and far above rounding.
constexpr double kRounding = 1e-12;

double filterLengthFor(const MotionLimits& limits)
{
    return 2.0 * limits.acceleration.radians() / limits.jerk.radians();
}

}  // namespace

AxisSetpoints::AxisSetpoints(const MotionLimits& limits, const TravelRange& travel, Angle position)
    : m_limits(limits), m_travel(travel)
{
    reset(position);
}

void AxisSetpoints::reset(Angle position)
{
    m_motion.reset(position.radians(), filterLengthFor(m_limits));
    m_setpoint = {.position = position, .rate = {}, .acceleration = {}};
}

void AxisSetpoints::setLimits(const MotionLimits& limits)
{
    m_limits = limits;
    if (atRest()) {
        reset(m_setpoint.position);
    }
}

void AxisSetpoints::setTravel(const TravelRange& travel)
{
    m_travel = travel;
}

// Averaging turns a jump from full braking to full acceleration into a jerk of 2 × acceleration / length.
double AxisSetpoints::acceleration() const
{
    return std::min(m_limits.acceleration.radians(), 0.5 * m_limits.jerk.radians() * m_motion.length());
}

Setpoint AxisSetpoints::follow(Seconds dt, Angle target, AngularRate targetRate)
{
    const double duration = dt.count();
    if (duration <= 0.0) {
        return m_setpoint;
    }
    // The average of a uniform motion lags by half the filter length. So the axis aims that far ahead.
    const double speed = m_limits.speed.radians();
    double rate = std::clamp(targetRate.radians(), -speed, speed);
    const Angle lead = target + Angle::fromRadians(0.5 * m_motion.length() * rate);
    const double end = m_travel.clamped(lead).radians();
    if (!m_travel.contains(lead)) {
        rate = 0.0;
    }
    return approachTo({.position = end - rate * duration, .rate = rate}, speed, duration);
}

Setpoint AxisSetpoints::arrive(Seconds dt, Angle target, Seconds time)
{
    const double duration = dt.count();
    if (duration <= 0.0) {
        return m_setpoint;
    }
    const double end = m_travel.clamped(target).radians();
    const MotionBounds bounds{.speed = m_limits.speed.radians(), .acceleration = acceleration()};
    const double left = time.count() - m_motion.length();
    return approachTo({.position = end, .rate = 0.0}, speedForRestTime(m_motion.latest(), end, bounds, left), duration);
}

Setpoint AxisSetpoints::approachTo(const MotionState& goal, double speed, double duration)
{
    const auto path = approach(m_motion.latest(), goal, {.speed = speed, .acceleration = acceleration()}, duration);
    const auto obstacle = endInTheWay(path);
    return advance(obstacle ? stopAt(*obstacle, speed, duration) : path);
}

Setpoint AxisSetpoints::run(Seconds dt, AngularRate rate)
{
    const double duration = dt.count();
    if (duration <= 0.0) {
        return m_setpoint;
    }
    const double speed = m_limits.speed.radians();
    const double wanted = std::clamp(rate.radians(), -speed, speed);
    const MotionState now = m_motion.latest();
    const auto path = changeRate(now, wanted, acceleration(), duration);
    const double fastest = std::max(std::abs(now.rate), std::abs(wanted));
    const auto obstacle = endInTheWay(path);
    return advance(obstacle ? stopAt(*obstacle, fastest, duration) : path);
}

// The axis may stop earlier than with the limits, never later.
Setpoint AxisSetpoints::brake(Seconds dt, AngularAcceleration deceleration)
{
    const double duration = dt.count();
    if (duration <= 0.0) {
        return m_setpoint;
    }
    return advance(changeRate(m_motion.latest(), 0.0, std::max(acceleration(), deceleration.radians()), duration));
}

// The end of the travel before which the axis could not stop after this path. Testing the end of each segment is
// enough, because within a segment the stopping place moves outwards only while the axis does. Motion back inside is
// always safe.
std::optional<double> AxisSetpoints::endInTheWay(const Path& path) const
{
    for (const Segment& segment : path.segments()) {
        const MotionState state = segment.end();
        const double stop = stopPosition(state, acceleration());
        if (state.rate > 0.0 && stop > m_travel.max.radians() + kRounding) {
            return m_travel.max.radians();
        }
        if (state.rate < 0.0 && stop < m_travel.min.radians() - kRounding) {
            return m_travel.min.radians();
        }
    }
    return std::nullopt;
}

// Moves towards the end and stops there. If limits or travel were reduced during the motion, the braking may have to
// exceed the limit. An axis beyond the end only stops.
Path AxisSetpoints::stopAt(double end, double speed, double duration) const
{
    const MotionState now = m_motion.latest();
    const double outside = end == m_travel.max.radians() ? now.position - end : end - now.position;
    if (outside > kRounding) {
        return changeRate(now, 0.0, acceleration(), duration);
    }
    const double distance = std::max(-outside, kRounding);
    const bool outwards = now.rate * (end - now.position) > 0.0;
    const double needed = outwards ? now.rate * now.rate / (2.0 * distance) : 0.0;
    const double braking = std::max(acceleration(), needed);
    return approach(now, {.position = end, .rate = 0.0}, {.speed = speed, .acceleration = braking}, duration);
}

Setpoint AxisSetpoints::advance(const Path& path)
{
    m_motion.append(path.segments());
    const MovingAverage::Sample sample = m_motion.sample();
    m_setpoint = {.position = Angle::fromRadians(sample.position),
                  .rate = AngularRate::fromRadians(sample.rate),
                  .acceleration = AngularAcceleration::fromRadians(sample.acceleration)};
    return m_setpoint;
}

TravelRange AxisSetpoints::untilRest() const
{
    const auto [lowest, highest] = m_motion.untilRestAt(stopPosition(m_motion.latest(), acceleration()));
    return {.min = Angle::fromRadians(lowest), .max = Angle::fromRadians(highest)};
}

bool AxisSetpoints::atRest() const
{
    return m_motion.atRest();
}

Seconds AxisSetpoints::restTime(Angle target) const
{
    const MotionBounds bounds{.speed = m_limits.speed.radians(), .acceleration = acceleration()};
    return Seconds(tracking::restTime(m_motion.latest(), m_travel.clamped(target).radians(), bounds) +
                   m_motion.length());
}

Seconds AxisSetpoints::filterLength() const
{
    return Seconds(m_motion.length());
}

}  // namespace boresight::tracking
