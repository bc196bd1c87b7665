// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/axis_profile.h"

namespace boresight::tracking {

// Room of the drive's own planner above what the host's profile asks for: it must never be the slower one.
inline constexpr double kLimitGuard = 1.5;

// What stops an axis that must not run on: at STOP, where its drive is not seen any more, and by the drive itself when
// the orders end. From full speed to rest in 0.08 s, behind a watchdog of 0.1 s within 0.2 s of the last order. But
// never more than fifteen times the acceleration that the profile asks of the mount.
[[nodiscard]] AngularAcceleration emergencyBraking(const MotionLimits& limits);

}  // namespace boresight::tracking
