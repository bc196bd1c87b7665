// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

// The limit above which the fault tests count an axis as moving. Below it the drive only pulls the axis over the last
// hundredths of a degree, against friction.
namespace boresight::system_test {

inline constexpr AngularRate kStandingStill = AngularRate::fromDegrees(0.3);

}  // namespace boresight::system_test
