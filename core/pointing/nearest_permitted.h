// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <optional>

namespace boresight::pointing {

class PermittedRegion;

// The permitted place with the smallest angle on the sky, so that a difference in azimuth counts less at a higher
// elevation. Keeps the turn. Empty if nothing is permitted. Pure values, any thread.
[[nodiscard]] std::optional<AxisPosition> nearestPermitted(const PermittedRegion& region, const AxisPosition& place);

// For a place that a person sets: the same azimuth at the next permitted whole degree of elevation above. If there is
// none, the nearest permitted place. Empty if nothing is permitted.
[[nodiscard]] std::optional<AxisPosition> easyPermitted(const PermittedRegion& region, const AxisPosition& place);

}  // namespace boresight::pointing
