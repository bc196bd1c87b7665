// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/rate_follower.h"

#include <algorithm>

namespace boresight {
namespace {

// A difference is corrected within one second. At twice this value the axis accelerates 1 % beyond its limit.
constexpr double kCorrection = 1.0;  // 1/s
// The drive rounds its control position down to steps of 2^-16 turns (0.0055°). The position computed from the orders
// is finer. If the report agrees with it, the report counts only with this share.
constexpr MotorTurns kReportedStep = MotorTurns::fromTurns(1.0 / 65536.0);
constexpr double kReportedShare = 0.2;
// Without replies the control position is computed from the orders. Three ticks without a reply mean two lost replies.
// After more than that the drive gets a position again.
constexpr int kMostUnheard = 3;
// Replies to frames that are older than this are not used.
constexpr std::size_t kMostTicks = 8;
// The planner of a standing drive is at most half a step from its goal. More acceleration than this share would only
// make noise.
constexpr double kGentle = 0.1;
// Below this the planner does not move by velocity (moteus manual). A new position in each tick moves it instead.
constexpr MotorRate kSmallestVelocity = MotorRate::fromTurns(0.0001);

MotionOrder toPlace(const MotorSetpoint& setpoint, MotorAcceleration acceleration)
{
    const bool slow = abs(setpoint.rate) < kSmallestVelocity;
    return {.place = setpoint.position, .rate = slow ? MotorRate{} : setpoint.rate, .acceleration = acceleration};
}

}  // namespace

void RateFollower::begin(SteadyTime now)
{
    m_ticks.push_back({.began = now, .control = after(m_ticks.back(), now)});
    if (m_ticks.size() > kMostTicks) {
        m_ticks.pop_front();
    }
    ++m_unheard;
}

std::optional<RateFollower::State> RateFollower::after(const Tick& tick, SteadyTime then)
{
    std::optional<State> control = tick.control;
    if (!control) {
        return control;
    }
    const Seconds passed = then - tick.began;
    const MotorRate before = control->rate;
    if (tick.order && !tick.order->place) {
        const MotorAcceleration most = tick.order->acceleration;
        const MotorRate wanted = tick.order->rate - before;
        const Seconds ramp = std::min(passed, Seconds(abs(wanted) / (most * Seconds(1.0))));
        const MotorRate change = std::clamp(wanted, -(most * ramp), most * ramp);
        control->rate = before + change;
        control->position += 0.5 * change * ramp + change * (passed - ramp);
    }
    control->position += before * passed;
    return control;
}

void RateFollower::heard(MotorTurns control, MotorRate rate, int ticksAgo)
{
    if (ticksAgo < 0 || static_cast<std::size_t>(ticksAgo) >= m_ticks.size()) {
        return;
    }
    std::size_t tick = m_ticks.size() - 1 - static_cast<std::size_t>(ticksAgo);
    const MotorTurns reported = control + 0.5 * kReportedStep;
    const auto& expected = m_ticks[tick].control;
    const bool agrees = known() && expected && abs(reported - expected->position) <= kReportedStep;
    m_ticks[tick].control =
        State{.position = agrees ? expected->position + kReportedShare * (reported - expected->position) : reported,
              .rate = rate};
    for (; tick + 1 < m_ticks.size(); ++tick) {
        m_ticks[tick + 1].control = after(m_ticks[tick], m_ticks[tick + 1].began);
    }
    m_unheard = 0;
}

void RateFollower::leave()
{
    m_ticks = {Tick{.began = m_ticks.back().began}};  // the drive may count from another zero when orders begin again
    m_lastAcceleration.reset();
}

bool RateFollower::known() const
{
    return m_ticks.back().control && m_unheard <= kMostUnheard;
}

MotionOrder RateFollower::follow(const MotorSetpoint& setpoint, const Limits& limits)
{
    const MotionOrder order = orderFor(setpoint, limits);
    m_ticks.back().order = order;
    m_lastAcceleration = setpoint.acceleration;
    return order;
}

MotionOrder RateFollower::orderFor(const MotorSetpoint& setpoint, const Limits& limits) const
{
    if (!known() || !limits.bounded) {
        return toPlace(setpoint, limits.acceleration);
    }
    const State& control = *m_ticks.back().control;
    const MotorTurns behind = setpoint.position - control.position;
    const MotorAcceleration gentle = kGentle * limits.acceleration;
    const auto within = [&](MotorRate change) {
        return std::clamp(abs(change) / limits.tick, gentle, limits.acceleration);
    };
    if (setpoint.rate == MotorRate{} && setpoint.acceleration == MotorAcceleration{}) {
        return toPlace(setpoint, within(control.rate));
    }
    if (abs(behind) > limits.speed * limits.tick) {
        return toPlace(setpoint, limits.acceleration);  // farther than lost frames can explain
    }
    // The acceleration is assumed to go on changing as before. This is its mean until the next set-point.
    const MotorAcceleration last = m_lastAcceleration.value_or(setpoint.acceleration);
    const MotorAcceleration mean = setpoint.acceleration + 0.5 * (setpoint.acceleration - last);
    const MotorRate fastest = std::max(limits.speed, abs(setpoint.rate));
    const MotorRate correction = kCorrection * behind / Seconds(1.0);
    const MotorRate rate = std::clamp(setpoint.rate + mean * limits.tick + correction, -fastest, fastest);
    return {.rate = rate, .acceleration = within(rate - control.rate)};
}

}  // namespace boresight
