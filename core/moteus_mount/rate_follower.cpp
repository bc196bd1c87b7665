// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/rate_follower.h"

#include <algorithm>

namespace boresight {
namespace {

// A difference is made good within about a second. Twice as fast, the axis accelerates 1 % beyond its limit.
constexpr double kCorrection = 1.0;  // 1/s
// The drive rounds its control position down to steps of 2^-16 turns (0.0055°). What its orders make of it is finer, so
// that a report which agrees with it counts for this share.
constexpr MotorTurns kReportedStep = MotorTurns::fromTurns(1.0 / 65536.0);
constexpr double kReportedShare = 0.2;
// Without replies the control position is what the orders make of it. After more than two lost ones the drive is told
// the place again.
constexpr int kMostUnheard = 3;
// The planner at rest has at most half a step to go. More acceleration than this share would only be heard.
constexpr double kGentle = 0.1;
// Slower than this the planner does not turn by velocity (moteus manual); a fresh position each tick moves it instead.
constexpr MotorRate kSmallestVelocity = MotorRate::fromTurns(0.0001);

MotionOrder toPlace(const MotorSetpoint& setpoint, MotorAcceleration acceleration)
{
    const bool slow = abs(setpoint.rate) < kSmallestVelocity;
    return {.place = setpoint.position, .rate = slow ? MotorRate{} : setpoint.rate, .acceleration = acceleration};
}

}  // namespace

void RateFollower::begin(SteadyTime now)
{
    const Seconds passed = now - m_began;
    m_began = now;
    ++m_unheard;
    if (!m_control) {
        return;
    }
    const MotorRate before = m_control->rate;
    if (m_order && !m_order->place) {
        const MotorRate wanted = m_order->rate - before;
        const Seconds ramp = std::min(passed, Seconds(abs(wanted) / (m_order->acceleration * Seconds(1.0))));
        const MotorRate change = std::clamp(wanted, -(m_order->acceleration * ramp), m_order->acceleration * ramp);
        m_control->rate = before + change;
        m_control->position += 0.5 * change * ramp + change * (passed - ramp);
    }
    m_control->position += before * passed;
}

void RateFollower::heard(MotorTurns control, MotorRate rate)
{
    const MotorTurns reported = control + 0.5 * kReportedStep;
    const bool agrees = known() && abs(reported - m_control->position) <= kReportedStep;
    m_control =
        State{.position = agrees ? m_control->position + kReportedShare * (reported - m_control->position) : reported,
              .rate = rate};
    m_unheard = 0;
}

void RateFollower::leave()
{
    m_control.reset();  // the drive may count from elsewhere when it is led again
    m_order.reset();
    m_lastAcceleration.reset();
}

bool RateFollower::known() const
{
    return m_control && m_unheard <= kMostUnheard;
}

MotionOrder RateFollower::follow(const MotorSetpoint& setpoint, const Limits& limits)
{
    m_order = orderFor(setpoint, limits);
    m_lastAcceleration = setpoint.acceleration;
    return *m_order;
}

MotionOrder RateFollower::orderFor(const MotorSetpoint& setpoint, const Limits& limits) const
{
    if (!known() || !limits.bounded) {
        return toPlace(setpoint, limits.acceleration);
    }
    const MotorTurns behind = setpoint.position - m_control->position;
    const MotorAcceleration gentle = kGentle * limits.acceleration;
    const auto within = [&](MotorRate change) {
        return std::clamp(abs(change) / limits.tick, gentle, limits.acceleration);
    };
    if (setpoint.rate == MotorRate{} && setpoint.acceleration == MotorAcceleration{}) {
        return toPlace(setpoint, within(m_control->rate));
    }
    if (abs(behind) > limits.speed * limits.tick) {
        return toPlace(setpoint, limits.acceleration);  // farther than lost frames explain
    }
    // The acceleration goes on changing as it did: its mean until the next set-point.
    const MotorAcceleration last = m_lastAcceleration.value_or(setpoint.acceleration);
    const MotorAcceleration mean = setpoint.acceleration + 0.5 * (setpoint.acceleration - last);
    const MotorRate fastest = std::max(limits.speed, abs(setpoint.rate));
    const MotorRate correction = kCorrection * behind / Seconds(1.0);
    const MotorRate rate = std::clamp(setpoint.rate + mean * limits.tick + correction, -fastest, fastest);
    return {.rate = rate, .acceleration = within(rate - m_control->rate)};
}

}  // namespace boresight
