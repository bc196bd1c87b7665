// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <optional>

namespace boresight::pointing {

class PermittedRegion;

// The permitted place with the smallest angle on the sky, so that a difference in azimuth counts less at a higher
// elevation. Keeps the turn. Empty if nothing is permitted. Pure values, any thread.
[[nodiscard]] std::optional<AxisPosition> nearestPermitted(const PermittedRegion& region, const AxisPosition& place);

}  // namespace boresight::pointing
