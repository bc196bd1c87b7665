// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/messages/capabilities.h"
#include "core/motion/guarded_axes.h"
#include "core/profile/profile.h"
#include "core/tracking/leeway.h"
#include "core/tracking/target_stream.h"
#include "core/units/sky.h"

#include <QString>

#include <array>
#include <optional>
#include <variant>
#include <vector>

// The motion of both axes: keeps what is wanted (rest, a place, a stream of places, a rate) and makes the next
// set-point of each axis from it, within speed, acceleration, jerk, travel and the permitted region. A target that can
// not be reached directly is reached by a route around the forbidden places. For a forbidden target the axes go to the
// nearest permitted place. An axis never gets a higher speed than the rotator has, and an axis that the rotator does
// not have stays at 0. Knows nothing of drives, clients or states. Pure: time is passed in. Angles are mechanical.
namespace boresight {

class Motion
{
public:
    explicit Motion(const profile::Profile& profile, const Capabilities& capabilities = {});

    // Takes over an axis that stands still at a measured angle. The target stays.
    void start(Axis axis, Angle measured);

    void rest();  // decelerate, then stay
    void goTo(const AxisPosition& place);
    void follow(const AxisPosition& point, SteadyTime now);  // one point of a stream
    void confirmStream(SteadyTime now);                      // the client of the stream has read the position
    void settleStream();                                     // no more points: stop at the last one
    void keepOn(SteadyTime now);                             // the stream continues straight without more points
    // The target is at `place` now and moves at `rates` until the next call. If a target that moved stands where the
    // set-points stop, an axis whose motor starts seldom stays where it is.
    void lead(const AxisPosition& place, const AxisRates& rates, SteadyTime now);
    void run(const AxisRates& rates);
    void setTrim(const AxisPosition& trim);  // added to the points of streams
    [[nodiscard]] const AxisPosition& trim() const { return m_trim; }

    // Settings of the profile that apply at once, also in the middle of a motion.
    void setRegion(const pointing::Region& region, const pointing::PointingModel& pointing);
    void setLimits(Axis axis, const tracking::MotionLimits& limits);
    // The limits of the profile, reduced to what the rotator can do.
    [[nodiscard]] const tracking::MotionLimits& limits(Axis axis) const { return m_limits[index(axis)]; }
    // For the last leg to a place that stands still: whether both axes arrive at the same time.
    void setArrival(profile::Arrival arrival) { m_arrival = arrival; }
    // While the wrap of an axis is unknown, the forbidden places are unknown, too, so only the travel counts.
    void enforceRegion(bool enforced) { m_axes.enforce(enforced); }
    // The ends of an axis that its end switches have closed.
    void close(Axis axis, const ClosedEnds& ends) { m_axes.close(axis, ends); }
    // The axis moves or wants to move on towards this end.
    [[nodiscard]] bool goesInto(Axis axis, bool isUpper) const { return m_axes.goesInto(axis, isUpper); }
    // How far beside a moving target an axis may stand whose motor is only switched on and off.
    struct Band
    {
        Angle width;
        Angle halfBeam;  // of the antenna
    };
    // Empty: each axis has to be at its set-point.
    void setBand(const std::optional<Band>& band) { m_band = band; }
    // The present position of the rotator, if it is known.
    void setSeen(const std::optional<AxisPosition>& place) { m_axes.setSeen(place); }

    // With `hard` the axes brake as hard as a drive that gets no commands, still with limited jerk. Otherwise within
    // the limits.
    void setHardBraking(bool hard) { m_hardBraking = hard; }
    // One step of braking. The target is kept until both axes can move again.
    void brake(Seconds step);
    // Moves the set-points on to `now`, which is `step` after the previous call.
    void advance(SteadyTime now, Seconds step);

    [[nodiscard]] const tracking::Setpoint& setpoint(Axis axis) const { return m_axes.setpoint(axis); }
    [[nodiscard]] AxisPosition place() const { return m_axes.place(); }      // of the set-points
    [[nodiscard]] std::optional<AxisPosition> target(SteadyTime now) const;  // empty while resting or running
    [[nodiscard]] bool streaming(SteadyTime now) const;                      // the points look like a path in the sky
    [[nodiscard]] std::optional<tracking::MovingTarget> path(SteadyTime now) const;  // the position on that path
    // How well the points of a stream show the target. Empty: there is no stream.
    [[nodiscard]] std::optional<tracking::StreamError> streamError(SteadyTime now) const;
    [[nodiscard]] bool atRest() const { return m_axes.atRest(); }  // both set-points stand still

    // How far beside its set-point each axis may be sent. For a motor that is only switched on and off.
    [[nodiscard]] std::array<tracking::Leeway, 2> leeway(SteadyTime now) const;
    // How far beside a moving target the axis of such a motor may stand.
    [[nodiscard]] Angle band(Axis axis, SteadyTime now) const;

    [[nodiscard]] const pointing::PermittedRegion& region() const { return m_axes.region(); }
    // The travel of the profile, ending at the last steps that the rotator can reach inside.
    [[nodiscard]] const TravelRange& travel(Axis axis) const
    {
        return axis == Axis::Azimuth ? m_axes.travel().azimuth : m_axes.travel().elevation;
    }
    // The way from one place to another, or an error with the reason if there is none.
    [[nodiscard]] Result<std::vector<AxisPosition>> route(const AxisPosition& from, const AxisPosition& to) const;
    // The remaining part of a route around forbidden places, with its end. Empty on a direct way.
    [[nodiscard]] const std::vector<AxisPosition>& route() const { return m_way.legs; }
    // The target is forbidden, so the axes go to the nearest permitted place.
    [[nodiscard]] bool limited() const { return m_limited.has_value(); }
    [[nodiscard]] bool limited(Axis axis) const;  // this axis is not at its target because of that
    // Why the target can not be reached, so that the axes brake. Empty while it can be reached.
    [[nodiscard]] const QString& noWay() const { return m_way.obstacle; }
    // The way of the rotator is not permitted any more. The rotator must stop and start again from where it is.
    [[nodiscard]] bool stray() const { return m_axes.stray(); }
    // The axis is at an edge, or brakes for it, and the target is beyond that edge.
    [[nodiscard]] bool held(Axis axis) const { return m_axes.held(axis); }
    // The obstacle that holds an axis or forbids the target: `the keep-out "mast"`. Empty if there is none.
    [[nodiscard]] QString obstacle() const;

private:
    struct Resting
    {};
    struct Straight
    {
        tracking::MovingTarget target;
        SteadyTime since;
        bool pauses = false;  // it moved before, and moves on later
    };
    using Wanted = std::variant<Resting, AxisPosition, tracking::TargetStream, Straight, AxisRates>;

    // The last planned way to the target.
    struct Way
    {
        std::vector<AxisPosition> legs;
        QString obstacle;  // why there is no way
        std::optional<AxisPosition> end;
        SteadyTime planned{};
    };

    [[nodiscard]] std::optional<tracking::MovingTarget> movingTarget(SteadyTime now) const;
    [[nodiscard]] bool pausesAt(const AxisPosition& place) const;
    [[nodiscard]] bool pauses() const;
    [[nodiscard]] bool follows(SteadyTime now) const;
    [[nodiscard]] Angle jogLead(Axis axis) const;
    // How far from its set-point the axis may stand, if nothing is forbidden near it.
    [[nodiscard]] Angle slack(Axis axis, SteadyTime now) const;
    [[nodiscard]] std::optional<tracking::MovingTarget> permitted(const tracking::MovingTarget& target);
    void driveTo(const tracking::MovingTarget& target, SteadyTime now, Seconds step);
    void stepTo(const tracking::MovingTarget& goal, Seconds step);
    void planTo(const AxisPosition& end, SteadyTime now);
    void forgetWay();

    Wanted m_wanted;
    AxisPosition m_trim{};
    Capabilities m_capabilities;
    GuardedAxes m_axes;
    std::array<tracking::MotionLimits, 2> m_limits;
    std::array<AngularAcceleration, 2> m_hardest;
    bool m_hardBraking = false;
    profile::Arrival m_arrival;
    std::optional<Band> m_band;
    Way m_way;
    struct Limited
    {
        AxisPosition target;   // forbidden
        AxisPosition nearest;  // the target that is used instead
    };
    std::optional<Limited> m_limited;
};

}  // namespace boresight
