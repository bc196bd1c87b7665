// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <optional>

namespace boresight::pointing {

class PermittedRegion;

// The permitted place that is nearest on the sky, where azimuth counts as wide as it is at this elevation. Keeps the
// turn. Empty if nothing is permitted. Pure values, any thread.
[[nodiscard]] std::optional<AxisPosition> nearestPermitted(const PermittedRegion& region, const AxisPosition& place);

}  // namespace boresight::pointing
