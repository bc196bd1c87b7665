// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/emergency_braking.h"

#include <algorithm>

namespace boresight::tracking {

AngularAcceleration emergencyBraking(const MotionLimits& limits)
{
    constexpr double kRamp = 0.08;  // s
    const double asked = limits.acceleration.degrees();
    return AngularAcceleration::fromDegrees(
        std::clamp(limits.speed.degrees() / kRamp, kLimitGuard * asked, 15.0 * asked));
}

}  // namespace boresight::tracking
