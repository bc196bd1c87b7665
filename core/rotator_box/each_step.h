// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/capabilities.h"
#include "core/profile/profile.h"
#include "core/tracking/axis_setpoints.h"
#include "core/units/quantity.h"

#include <optional>

// The target of an axis that gets each step of its set-point, because its motor may start often. Pure.
namespace boresight {

[[nodiscard]] Angle inSteps(Angle angle, Angle step);
// The nearest step inside `within`. If there is none, the nearest step.
[[nodiscard]] Angle stepInside(Angle angle, Angle step, const TravelRange& within);

// The steps of one axis, and the last target among them.
class EachStep
{
public:
    // A target that turns back moves the axis only when it is this far away, in steps. So a target that jitters at the
    // border between two steps sends the axis to one of them only.
    static constexpr double kTurnsBack = AxisCapabilities::kMostOfAStep;

    // `place`: the position where the axis was taken over.
    void begin(Angle place, Angle step);
    // The target is not farther ahead than the axis needs to stop, and inside `within`: what lies beyond may be
    // forbidden. It is not far from `place`, the position of the axis: it must not move far when the line fails.
    // Returns true if the target is another one.
    [[nodiscard]] bool aim(const tracking::Setpoint& setpoint, const profile::AxisSettings& axis,
                           const std::optional<Angle>& place, Angle step, const TravelRange& within);
    // Empty before begin().
    [[nodiscard]] const std::optional<Angle>& target() const { return m_target; }

private:
    std::optional<Angle> m_target;
    double m_way = 0.0;  // the direction of the last change: -1, 1; 0 before the first
};

}  // namespace boresight
