// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/axis_setpoints.h"

namespace boresight::tracking {

// The limits of the drive's own planner are higher than those of the profile by this factor, so that the drive never
// lags.
inline constexpr double kLimitGuard = 1.5;

// The deceleration of an axis that must not run on: at STOP, when its drive is silent, and by the drive itself when the
// commands end. It stops the axis from full speed in 0.08 s. With the watchdog of 0.1 s the axis stands still within
// 0.2 s of the last command. At most fifteen times the acceleration of the profile.
[[nodiscard]] AngularAcceleration emergencyBraking(const MotionLimits& limits);

}  // namespace boresight::tracking
