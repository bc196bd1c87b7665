// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/capabilities.h"
#include "core/motion/axis_ends.h"
#include "core/pointing/permitted_region.h"
#include "core/profile/profile.h"
#include "core/tracking/axis_setpoints.h"
#include "core/units/sky.h"

#include <QString>

#include <array>
#include <optional>

// The set-points of both axes, kept inside the permitted region whatever is asked and by whom. This is the last guard,
// below every source of motion.
// In each step an axis gets the room that is free while the other axis is anywhere between its present and its stopping
// position. So both axes can always still brake, and they slide along an edge. An axis that the rotator does not have
// stays at 0.
// For an axis that moves in steps, travel and limits end at the last step inside. The way from the position of such a
// rotator to the set-points must be free, too, in whatever order its axes move. If the rotator is slower than the
// profile says, the set-points wait.
// From a forbidden position (an edited mask, a mount that was pushed) the set-points only move out. Pure, one thread.
// See README.md.
namespace boresight {

// An axis that is nearer than this to an end of the travel or to another edge is at that edge. A target this near
// counts as reached.
inline constexpr Angle kAtEdge = Angle::fromDegrees(0.05);

// The wish for one axis: to go to a target that moves at `rate`, or without a target to move at `rate`. Rate zero means
// brake, with `braking` if the limits of the axis are not enough. With `arrival` the axis goes to a standing target and
// arrives no earlier than after this time.
struct AxisWish
{
    std::optional<Angle> target{};
    AngularRate rate{};
    std::optional<AngularAcceleration> braking{};
    std::optional<Seconds> arrival{};
};

class GuardedAxes
{
public:
    explicit GuardedAxes(const profile::Profile& profile, const Capabilities& capabilities = {});

    // Takes over an axis that stands still at a measured angle.
    void start(Axis axis, Angle measured);
    // The present position of the rotator.
    void setSeen(const std::optional<AxisPosition>& place);
    void step(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation);

    // Valid from the next step on. New limits of motion are reached gradually (AxisSetpoints).
    void setRegion(const pointing::Region& region, const pointing::PointingModel& pointing);
    void setLimits(Axis axis, const tracking::MotionLimits& limits);
    // While the wrap of an axis is unknown, the forbidden places are unknown, too, so only the travel counts.
    void enforce(bool enforced);

    // From the next step on the set-points do not pass the place where they would stop by now. An end stays closed
    // until the next call.
    void close(Axis axis, const ClosedEnds& ends) { m_ends[index(axis)].close(ends); }
    // The set-points move or want to move on towards this end of the axis, or the rotator does.
    [[nodiscard]] bool goesInto(Axis axis, bool isUpper) const;

    [[nodiscard]] const pointing::PermittedRegion& region() const { return m_region; }
    // The travel of the profile, ending at the last steps that the rotator can reach inside.
    [[nodiscard]] const pointing::AxisBox& travel() const { return m_travel; }
    [[nodiscard]] bool enforced() const { return m_enforced; }
    [[nodiscard]] const tracking::Setpoint& setpoint(Axis axis) const;
    [[nodiscard]] AxisPosition place() const;
    [[nodiscard]] bool atRest() const;
    // True in three cases. The way of the rotator to the set-points is not permitted any more, because an edge was
    // moved into it. The rotator was left behind there. Or no motion is wanted any more and the rotator is far behind.
    // A rotator whose motors start seldom is also stray if no target is wanted any more, until it is taken over again.
    [[nodiscard]] bool stray() const { return m_stray; }
    // Where both axes may be while the set-points are where they are: all that they pass until they stand still, the
    // reported position, and `room` beside that, inside travel and limits. If another edge is in that box, it is not
    // `free` and has at most a step beside.
    struct Surroundings
    {
        pointing::AxisBox box;
        bool free = false;
    };
    [[nodiscard]] Surroundings surroundings(const AxisPosition& room) const;
    // Where the set-point stops if it brakes from this tick on.
    [[nodiscard]] Angle restOf(Axis axis) const;
    // The shortest time until both axes stand still at `target`, if nothing is in the way.
    [[nodiscard]] Seconds restTime(const AxisPosition& target) const;
    // The axis was asked to go on, but is at an edge of the permitted region, or brakes for it.
    [[nodiscard]] bool held(Axis axis) const { return m_held[axis == Axis::Azimuth ? 0 : 1] != 0; }
    // The obstacle that holds the axes: `the keep-out "mast"`. Empty if there is none.
    [[nodiscard]] QString obstacle() const;

private:
    // The observed position of one axis of the rotator.
    struct Sight
    {
        std::optional<Angle> place;
        Angle stood{};      // the axis has been near this angle
        Seconds time{0.0};  // for this time
    };

    [[nodiscard]] TravelRange openPart(Axis axis, const TravelRange& room) const
    {
        return m_ends[index(axis)].openPart(room);
    }
    [[nodiscard]] bool isAnyClosed() const;
    [[nodiscard]] bool lagsTowards(Axis axis, bool isUpper) const;
    [[nodiscard]] bool runsIntoClosed() const;
    [[nodiscard]] TravelRange travelOf(Axis axis, const profile::Profile& profile) const;
    [[nodiscard]] pointing::Region reachable(pointing::Region region) const;
    [[nodiscard]] pointing::AxisBox untilRest() const;
    void watch(Seconds duration);
    [[nodiscard]] bool lags(Axis axis) const;
    [[nodiscard]] bool strays() const;
    [[nodiscard]] bool runsAfter(const AxisWish& azimuth, const AxisWish& elevation);
    [[nodiscard]] bool startsSeldom() const;
    [[nodiscard]] pointing::AxisBox fromSeen(pointing::AxisBox box) const;
    void stepGuarded(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation);
    void stepFree(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation);
    void stepInside(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation);
    void stepOut(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation);
    void brake(Seconds duration, const pointing::AxisBox& within, const AxisWish& azimuth, const AxisWish& elevation);

    Capabilities m_capabilities;
    pointing::AxisBox m_travel;
    pointing::PermittedRegion m_region;
    tracking::AxisSetpoints m_azimuth;
    tracking::AxisSetpoints m_elevation;
    std::array<tracking::AxisSetpoints, 2> m_trial;  // of stepInside(), kept because its memory is used again
    std::array<Sight, 2> m_sights;
    bool m_enforced = true;
    bool m_leaves = false;  // on its way out of a forbidden place
    bool m_stray = false;
    bool m_settles = false;                    // a motion was wanted, and the rotator has not arrived yet
    bool m_aimed = false;                      // a target was wanted since the rotator was taken over
    std::optional<pointing::AxisBox> m_swept;  // permitted: all that was left to pass after the last step
    std::array<AxisEnds, 2> m_ends;            // that are closed
    std::array<int, 2> m_held{};               // the direction in which each axis wants to move but may not: -1, 0, 1
};

}  // namespace boresight
