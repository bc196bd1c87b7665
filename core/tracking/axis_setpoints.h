// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/moving_average.h"
#include "core/units/sky.h"

#include <optional>

// The set-point of one axis. Each control tick moves it towards its goal within speed, acceleration, jerk and travel. A
// time-optimal motion (bang-bang, exact within the tick) is averaged over the last 2 × acceleration /
// jerk seconds. The average of a motion stays inside the motion, and its jerk is limited. METHOD.md gives the reasons.
// Pure values, one thread.
namespace boresight::tracking {

struct MotionLimits
{
    AngularRate speed;
    AngularAcceleration acceleration;
    AngularJerk jerk;

    bool operator==(const MotionLimits&) const = default;
};

// The wanted state of the axis at the end of a tick.
struct Setpoint
{
    Angle position;
    AngularRate rate;
    AngularAcceleration acceleration;

    bool operator==(const Setpoint&) const = default;
};

class AxisSetpoints
{
public:
    // Standing still at `position`. It may be outside the travel: then the axis stays there, and every motion leads
    // back inside.
    AxisSetpoints(const MotionLimits& limits, const TravelRange& travel, Angle position);

    // Standing still at a measured position, with no memory of earlier motion. Call it when the drive takes the first
    // command, and after the drive was not under our control. During control it would be a step.
    void reset(Angle position);

    // Applies from the next tick on. A new filter length applies only when the axis next stands still. Until then the
    // acceleration is reduced if the new jerk limit requires that. If reduced limits would no longer stop the axis
    // before the end of its travel, the travel has priority.
    void setLimits(const MotionLimits& limits);
    void setTravel(const TravelRange& travel);

    // The following functions are called once per tick. The returned set-point is for the end of the tick, `dt` after
    // the previous set-point.
    //
    // Moves to a target that will be at `target` at the end of the tick and moves at `targetRate`. A target beyond the
    // travel means the end of the travel. Once reached, a moving target is tracked without lag.
    Setpoint follow(Seconds dt, Angle target, AngularRate targetRate = {});
    // Moves to a fixed target and stops there after `time` at the earliest. Used so that both axes arrive together:
    // `time` is restTime() of the slower axis.
    Setpoint arrive(Seconds dt, Angle target, Seconds time);
    // Moves at this rate until another call. Stops at the end of the travel.
    Setpoint run(Seconds dt, AngularRate rate);
    // Stops as fast as the limits allow, and stays there.
    Setpoint brake(Seconds dt) { return run(dt, AngularRate{}); }
    // The same with a higher deceleration, averaged like every motion.
    Setpoint brake(Seconds dt, AngularAcceleration deceleration);

    [[nodiscard]] const Setpoint& setpoint() const { return m_setpoint; }
    // The range that the set-point still passes if the axis brakes from now on, including its present position.
    [[nodiscard]] TravelRange untilRest() const;
    // The set-point stands still: rate and acceleration are exactly zero and stay so until the goal changes.
    [[nodiscard]] bool atRest() const;
    // The shortest time until the axis stands still at a fixed target.
    [[nodiscard]] Seconds restTime(Angle target) const;
    // The duration of the averaging. The axis arrives later than the time-optimal motion by this time.
    [[nodiscard]] Seconds filterLength() const;

private:
    [[nodiscard]] double acceleration() const;
    [[nodiscard]] std::optional<double> endInTheWay(const Path& path) const;
    [[nodiscard]] Path stopAt(double end, double speed, double duration) const;
    Setpoint approachTo(const MotionState& goal, double speed, double duration);
    Setpoint advance(const Path& path);

    MotionLimits m_limits;
    TravelRange m_travel;
    MovingAverage m_motion;
    Setpoint m_setpoint;
};

}  // namespace boresight::tracking
