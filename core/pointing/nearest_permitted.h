// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <optional>

namespace boresight::pointing {

class PermittedRegion;

// The permitted place nearest on the sky, azimuth counted as wide as it is at this elevation; the turn is kept. Empty
// when nothing at all is permitted. Pure values, any thread.
[[nodiscard]] std::optional<AxisPosition> nearestPermitted(const PermittedRegion& region, const AxisPosition& place);

}  // namespace boresight::pointing
