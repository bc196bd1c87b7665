// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"
#include "core/tracking/axis_profile.h"
#include "core/units/quantity.h"

#include <optional>

// The target of an axis that gets each step of its set-point, because its motor may start often. Pure.
namespace boresight {

[[nodiscard]] Angle inSteps(Angle angle, Angle step);
// The target is not farther ahead than the axis needs to stop: only the way up to that point is known to be permitted.
// It is not far from `place`, the position of the axis: it must not move far when the line fails.
[[nodiscard]] Angle eachStep(const tracking::Setpoint& setpoint, const profile::AxisSettings& axis,
                             const std::optional<Angle>& place, Angle step);

}  // namespace boresight
