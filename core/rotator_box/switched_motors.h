// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/capabilities.h"
#include "core/profile/in_force.h"
#include "core/rotator_box/rotator_talk.h"
#include "core/rotator_box/switched_axis.h"
#include "core/tracking/leeway.h"
#include "core/units/sky.h"

#include <array>
#include <optional>

// Both axes of a rotator whose motors are only switched on and off. A command contains a target for each axis, so this
// decides when a command is sent, and which target the other axis gets: the one with which it continues its present
// motion, or stands. Also an axis that the rotator has and this mount does not turn gets such a target. Pure: time and
// positions are passed in.
namespace boresight {

class SwitchedMotors
{
public:
    // Empty: no new target for this axis.
    using Targets = std::array<std::optional<Angle>, 2>;

    // The profile outlives this. `steps`: targets of each axis are multiples of it, also where this mount does not turn
    // the axis. `count`: the resolution of the positions.
    SwitchedMotors(const profile::InForce& profile, const Capabilities& capabilities, const std::array<Angle, 2>& steps,
                   Angle count);

    void see(Axis axis, Angle place, SteadyTime now) { of(axis).see(place, now); }
    // The next positions may be those of another rotator.
    void forget();
    void begin();
    void stopped(SteadyTime now);
    void setLeeway(Axis axis, const tracking::Leeway& leeway) { m_leeways[index(axis)] = leeway; }
    [[nodiscard]] const tracking::Leeway& leeway(Axis axis) const { return m_leeways[index(axis)]; }

    // The new targets of this moment.
    [[nodiscard]] Targets next(SteadyTime now);
    // For an axis that did not obey its last target.
    [[nodiscard]] Targets again(Axis axis);
    // What the command contains. Empty only for an axis whose position is unknown.
    [[nodiscard]] RotatorTalk::Places command(const Targets& targets) const;
    void sent(const Targets& targets, SteadyTime now);

    [[nodiscard]] bool stand() const;
    [[nodiscard]] const SwitchedAxis& axis(Axis axis) const { return m_axes[index(axis)]; }

private:
    [[nodiscard]] SwitchedAxis& of(Axis axis) { return m_axes[index(axis)]; }
    [[nodiscard]] SwitchedAxis::Habits habits(Axis axis) const;

    const profile::InForce& m_profile;
    const Capabilities m_capabilities;
    std::array<Angle, 2> m_steps;
    Angle m_count;
    std::array<SwitchedAxis, 2> m_axes;
    std::array<tracking::Leeway, 2> m_leeways{};
};

}  // namespace boresight
