// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/moving_average.h"
#include "core/units/sky.h"

#include <optional>
#include <vector>

// The set-point of one axis, moved each control tick towards its goal within speed, acceleration, jerk and travel.
// A time-optimal second-order profile (bang-bang, exact inside the tick) is averaged over the last 2 × acceleration /
// jerk seconds: the average of a motion is never outside of it, and its jerk is bounded. METHOD.md argues it.
// Pure values, one thread.
namespace boresight::tracking {

struct MotionLimits
{
    AngularRate speed;
    AngularAcceleration acceleration;
    AngularJerk jerk;

    bool operator==(const MotionLimits&) const = default;
};

// What the axis is asked to be at the end of a tick.
struct Setpoint
{
    Angle position;
    AngularRate rate;
    AngularAcceleration acceleration;

    bool operator==(const Setpoint&) const = default;
};

class AxisProfile
{
public:
    // At rest at `position`, which may lie outside the travel: it is held there, and every motion leads back inside.
    AxisProfile(const MotionLimits& limits, const TravelRange& travel, Angle position);

    // At rest at a measured position, everything before forgotten. For the moment when the drive takes over the first
    // command, and after it was out of our hands. Between them this would be a step.
    void reset(Angle position);

    // From the next tick on. A filter length that follows from new limits takes force when the axis next rests;
    // until then acceleration is lowered where the new jerk asks for it. Where lowered limits would no longer stop the
    // axis before the end of its travel, the travel wins.
    void setLimits(const MotionLimits& limits);
    void setTravel(const TravelRange& travel);

    // One tick. The returned set-point belongs to its end, `dt` after the previous one.
    //
    // Goes to a target that at the end of the tick is at `target` and moves at `targetRate`. Targets beyond the travel
    // mean its end. Reached, a moving target is followed without lag.
    Setpoint follow(Seconds dt, Angle target, AngularRate targetRate = {});
    // Goes to a target that stands, and rests there no sooner than after `time`, which restTime() gives for the axis
    // that is later.
    Setpoint arrive(Seconds dt, Angle target, Seconds time);
    // Runs at a rate until told otherwise; comes to rest at the end of the travel.
    Setpoint run(Seconds dt, AngularRate rate);
    // Comes to rest as fast as the limits allow, and stays there.
    Setpoint brake(Seconds dt) { return run(dt, AngularRate{}); }
    // The same with a stronger deceleration, averaged as every motion.
    Setpoint brake(Seconds dt, AngularAcceleration deceleration);

    [[nodiscard]] const Setpoint& setpoint() const { return m_setpoint; }
    // All that the set-point still passes when the axis brakes from now on, where it is now included.
    [[nodiscard]] TravelRange untilRest() const;
    // The set-point rests (exactly: rate and acceleration are zero and stay so until the goal changes).
    [[nodiscard]] bool atRest() const;
    // How long it takes at least until the axis rests at a target that stands.
    [[nodiscard]] Seconds restTime(Angle target) const;
    // How long the averaging takes, hence how much later than the time-optimal profile the axis arrives.
    [[nodiscard]] Seconds filterLength() const;

private:
    [[nodiscard]] double acceleration() const;
    [[nodiscard]] std::optional<double> endInTheWay(const std::vector<Segment>& path) const;
    [[nodiscard]] std::vector<Segment> stopAt(double end, double speed, double duration) const;
    Setpoint approachTo(const MotionState& goal, double speed, double duration);
    Setpoint advance(const std::vector<Segment>& path);

    MotionLimits m_limits;
    TravelRange m_travel;
    MovingAverage m_motion;
    Setpoint m_setpoint;
};

}  // namespace boresight::tracking
