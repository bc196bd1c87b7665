// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"
#include "core/units/sky.h"

#include <vector>

// The possible angles of an axis whose drive cannot distinguish angles a whole `period` apart. Pure; mechanical angles.
namespace boresight::journal {

// An unpowered axis coasts beyond its travel: 5.2° in tests/system/FAULTS.md, or into rubber stops that yield by 8°.
inline const Angle kBeyondTravel = Angle::fromDegrees(15.0);

// All possible angles within the travel, extended by kBeyondTravel at both ends, in order.
[[nodiscard]] std::vector<Angle> placesAround(Angle reported, Angle period, const TravelRange& travel);

}  // namespace boresight::journal
