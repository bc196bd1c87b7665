// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <deque>
#include <optional>

// Moves one drive along the set-points without chatter. A new position in each tick makes the planner of the drive
// switch its acceleration to and fro. So while the set-points move, the drive gets a velocity, and just the
// acceleration that reaches this velocity in one tick. Each reply contains the control position of the drive. It is
// compared with the set-point, and the velocity corrects the difference. The planner gets a position instead in three
// cases: the set-point stands still, the control position is unknown, or the drive has no bounds of its own. Pure: time
// is passed in. Units are those of the drive.
namespace boresight {

struct MotorSetpoint
{
    MotorTurns position;
    MotorRate rate;
    MotorAcceleration acceleration;
};

// With a place: the planner moves there and passes the place at the rate. Without a place: reach the rate.
struct MotionOrder
{
    std::optional<MotorTurns> place{};
    MotorRate rate{};
    MotorAcceleration acceleration{};  // the most that the drive may use
};

class RateFollower
{
public:
    struct Limits
    {
        MotorRate speed;                 // of the axis. The correction does not exceed it
        MotorAcceleration acceleration;  // the most that the drive may use
        Seconds tick;
        bool bounded = true;  // the drive has its own position bounds, where a velocity ends
    };

    // A tick begins. The last order is in force until now.
    void begin(SteadyTime now);
    // The reply of the drive to the frame of `ticksAgo` ticks before (0: of this tick). It contains the control
    // set-points from before that frame took effect. A constant delay of frames and replies does no harm.
    void heard(MotorTurns control, MotorRate rate, int ticksAgo = 0);
    // Frames other than the orders of this class are sent, or the state of the drive is unknown.
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

    // The state that the drive reaches at the time `then` by the order of this tick.
    [[nodiscard]] static std::optional<State> after(const Tick& tick, SteadyTime then);
    [[nodiscard]] bool known() const;
    [[nodiscard]] MotionOrder orderFor(const MotorSetpoint& setpoint, const Limits& limits) const;

    std::deque<Tick> m_ticks{Tick{}};                     // the current tick is the last element
    std::optional<MotorAcceleration> m_lastAcceleration;  // of the set-points
    int m_unheard = 0;                                    // ticks without a reply
};

}  // namespace boresight
