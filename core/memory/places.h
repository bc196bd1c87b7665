// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"
#include "core/units/sky.h"

#include <vector>

// Where an axis may stand when its drive cannot tell places a whole `period` apart. Pure; mechanical angles.
namespace boresight::memory {

// An axis that is let go coasts beyond its travel: 5.2° in tests/system/FAULTS.md, into rubber stops of 8°, which
// yield.
inline const Angle kBeyondTravel = Angle::fromDegrees(15.0);

// All within the travel and kBeyondTravel more at both ends, in order.
[[nodiscard]] std::vector<Angle> placesAround(Angle reported, Angle period, const TravelRange& travel);

}  // namespace boresight::memory
