// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

// When the tests of faults say that an axis stands: what is faster counts as motion. Below it the drive only pulls the
// axis the last hundredths of a degree to its place, against friction.
namespace boresight::system_test {

inline constexpr AngularRate kStandingStill = AngularRate::fromDegrees(0.3);

}  // namespace boresight::system_test
