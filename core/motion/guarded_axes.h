// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/capabilities.h"
#include "core/pointing/permitted_region.h"
#include "core/profile/profile.h"
#include "core/tracking/axis_profile.h"
#include "core/units/sky.h"

#include <QString>

#include <array>
#include <optional>

// The set-points of both axes, kept inside the permitted region whatever is asked of them and by whom: below every
// source of motion this is what holds. In each step an axis gets as much room as is free while the other one is
// anywhere between where it is and where it would stop, so both can always still brake, and along an edge they
// slide. An axis that the rotator does not have stays at 0. Travel and limits of an axis that goes in steps end at the
// last step inside. The way from where such a rotator is seen to the set-points is as free as theirs, in
// whatever order its axes go: one that is slower than the profile says makes the set-points wait. From a forbidden
// place (an edited mask, a mount that was pushed) they only move out. Pure, one thread; README.md.
namespace boresight {

// Nearer to an end of the travel, or to another edge, than this an axis stands at it. A target this near is reached.
inline constexpr Angle kAtEdge = Angle::fromDegrees(0.05);

// What one axis is asked: to go to a target that moves at `rate`, or without a target to run at `rate`. Zero: brake,
// with `braking` where the limits of the axis are not enough. With `arrival` it goes to a target that stands, and
// arrives no sooner than after this time.
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
    // Where the rotator is now.
    void setSeen(const std::optional<AxisPosition>& place);
    void step(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation);

    // From the next step on. New limits of motion take their time (AxisProfile).
    void setRegion(const pointing::Region& region, const pointing::PointingModel& pointing);
    void setLimits(Axis axis, const tracking::MotionLimits& limits);
    // While nobody knows on which turn an axis stands, nobody knows what is forbidden: only the travel counts.
    void enforce(bool enforced);

    [[nodiscard]] const pointing::PermittedRegion& region() const { return m_region; }
    // Of the profile, between the last steps that the rotator reaches there.
    [[nodiscard]] const pointing::AxisBox& travel() const { return m_travel; }
    [[nodiscard]] bool enforced() const { return m_enforced; }
    [[nodiscard]] const tracking::Setpoint& setpoint(Axis axis) const;
    [[nodiscard]] AxisPosition place() const;
    [[nodiscard]] bool atRest() const;
    // The rotator is on a way to the set-points that is permitted no more, since an edge was moved into it, or it was
    // left behind there. Or nothing is wanted any more, and it is far behind.
    [[nodiscard]] bool stray() const { return m_stray; }
    // How long it takes at least until both axes rest there, if nothing is in the way.
    [[nodiscard]] Seconds restTime(const AxisPosition& target) const;
    // The axis was asked to go on, but stands at, or brakes for, an edge of what is permitted.
    [[nodiscard]] bool held(Axis axis) const { return m_held[axis == Axis::Azimuth ? 0 : 1] != 0; }
    // What holds it: `the keep-out "mast"`. Empty if nothing does.
    [[nodiscard]] QString obstacle() const;

private:
    // Of one axis of the rotator.
    struct Sight
    {
        std::optional<Angle> place;
        Angle stood{};      // near there
        Seconds time{0.0};  // for so long
    };

    [[nodiscard]] TravelRange travelOf(Axis axis, const profile::Profile& profile) const;
    [[nodiscard]] pointing::Region reachable(pointing::Region region) const;
    [[nodiscard]] pointing::AxisBox untilRest() const;
    void watch(Seconds duration);
    [[nodiscard]] bool lags(Axis axis) const;
    [[nodiscard]] bool strays() const;
    [[nodiscard]] bool runsAfter(const AxisWish& azimuth, const AxisWish& elevation);
    [[nodiscard]] pointing::AxisBox fromSeen(pointing::AxisBox box) const;
    void stepGuarded(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation);
    void stepFree(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation);
    void stepInside(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation);
    void stepOut(Seconds duration, const AxisWish& azimuth, const AxisWish& elevation);
    void brake(Seconds duration, const pointing::AxisBox& within, const AxisWish& azimuth, const AxisWish& elevation);

    Capabilities m_capabilities;
    pointing::AxisBox m_travel;
    pointing::PermittedRegion m_region;
    tracking::AxisProfile m_azimuth;
    tracking::AxisProfile m_elevation;
    std::array<Sight, 2> m_sights;
    bool m_enforced = true;
    bool m_leaves = false;  // a forbidden place
    bool m_stray = false;
    bool m_settles = false;                    // something was wanted, and the rotator is not there yet
    std::optional<pointing::AxisBox> m_swept;  // permitted, and all that was left to pass after the last step
    std::array<int, 2> m_held{};               // which way each axis wants to go and may not: -1, 0, 1
};

}  // namespace boresight
