// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <deque>
#include <optional>

// How one drive is led along the set-points without chatter. A position that is new in each tick makes the planner of
// the drive switch its acceleration to and fro. So while the set-points move the drive is given a velocity, and just
// the acceleration that reaches it in one tick. Its own control position, which each reply contains, is compared with
// the set-point, and the velocity corrects the difference. A set-point at rest, a drive whose control position is not
// known, and one without bounds of its own are left to the planner, whose place is absolute. Pure: time is passed in.
// Units are the drive's.
namespace boresight {

struct MotorSetpoint
{
    MotorTurns position;
    MotorRate rate;
    MotorAcceleration acceleration;
};

// With a place: go there by the planner, and pass it at the rate. Without one: reach the rate.
struct MotionOrder
{
    std::optional<MotorTurns> place{};
    MotorRate rate{};
    MotorAcceleration acceleration{};  // at most
};

class RateFollower
{
public:
    struct Limits
    {
        MotorRate speed;                 // of the axis: no correction exceeds it
        MotorAcceleration acceleration;  // what the drive may use at most
        Seconds tick;
        bool bounded = true;  // the drive keeps its own position bounds: a velocity ends there
    };

    // A tick begins: what was ordered last is in force until now.
    void begin(SteadyTime now);
    // The drive's reply to the frame of this tick, or to that of so many ticks before: its control set-points before
    // that frame took effect. How late frames and replies are does not matter, as long as it stays the same.
    void heard(MotorTurns control, MotorRate rate, int ticksAgo = 0);
    // Other frames than orders of this are sent, or nothing is known of the drive any more.
    void leave();

    // The order of this tick.
    [[nodiscard]] MotionOrder follow(const MotorSetpoint& setpoint, const Limits& limits);

private:
    struct State
    {
        MotorTurns position;
        MotorRate rate;
    };

    struct Tick
    {
        SteadyTime began{};
        std::optional<State> control{};      // of the drive, when the frame of this tick reaches it
        std::optional<MotionOrder> order{};  // in force since then
    };

    // What the drive makes of the order of a tick until then.
    [[nodiscard]] static std::optional<State> after(const Tick& tick, SteadyTime then);
    [[nodiscard]] bool known() const;
    [[nodiscard]] MotionOrder orderFor(const MotorSetpoint& setpoint, const Limits& limits) const;

    std::deque<Tick> m_ticks{Tick{}};                     // the running one is the last
    std::optional<MotorAcceleration> m_lastAcceleration;  // of the set-points
    int m_unheard = 0;                                    // ticks
};

}  // namespace boresight
