// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/region.h"
#include "core/units/sky.h"

// A mount with one axis: the other one stands at 0. Nobody knows where the beam is in the angle that is missing, so
// what is forbidden for one value of it is forbidden for all. Pure.
namespace boresight::pointing {

// Around 0, wide enough not to be a slit (slits.h).
inline constexpr TravelRange kMissingAxisTravel{.min = Angle::fromDegrees(-1.0), .max = Angle::fromDegrees(1.0)};

// What is left of the region for the other axis. The limits of the missing axis are gone. A keep-out holds for all its
// angles. Without an azimuth the highest point of the horizon holds, without an elevation there is no horizon.
[[nodiscard]] Region withoutAxis(Region region, Axis missing);

}  // namespace boresight::pointing
