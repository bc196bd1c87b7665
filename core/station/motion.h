// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/profile/profile.h"
#include "core/tracking/axis_profile.h"
#include "core/tracking/target_stream.h"
#include "core/units/sky.h"

#include <optional>
#include <variant>

// Both axes on their way: keeps what is wanted (rest, a place, a stream of places, a rate) and makes the next set-point
// of each axis from it, within speed, acceleration, jerk and travel. Knows nothing of drives, clients or states. Pure:
// time is passed in. Angles are mechanical.
namespace boresight {

class Motion
{
public:
    explicit Motion(const profile::Profile& profile);

    // Takes over an axis that stands at a measured angle, at rest there. What is wanted stays.
    void start(Axis axis, Angle measured);

    void rest();  // decelerate, then stay
    void goTo(const AxisPosition& place);
    void follow(const AxisPosition& point, SteadyTime now);  // one point of a stream
    void confirmStream(SteadyTime now);                      // its client has read the position
    void settleStream();                                     // no more points: come to rest at the last one
    void run(const AxisRates& rates);

    // One step of braking; what is wanted stays, for when both axes can move again.
    void brake(Seconds step);
    // Moves the set-points on to `now`, `step` after the previous call.
    void advance(SteadyTime now, Seconds step);

    [[nodiscard]] const tracking::Setpoint& setpoint(Axis axis) const;
    [[nodiscard]] AxisPosition place() const;                                // of the set-points
    [[nodiscard]] std::optional<AxisPosition> target(SteadyTime now) const;  // empty while resting or running
    [[nodiscard]] bool streaming(SteadyTime now) const;                      // the points look like a path in the sky
    [[nodiscard]] bool atRest() const;                                       // both set-points stand still

private:
    struct Resting
    {};
    using Wanted = std::variant<Resting, AxisPosition, tracking::TargetStream, AxisRates>;

    [[nodiscard]] std::optional<tracking::MovingTarget> movingTarget(SteadyTime now) const;

    Wanted m_wanted;
    tracking::AxisProfile m_azimuth;
    tracking::AxisProfile m_elevation;
};

}  // namespace boresight
