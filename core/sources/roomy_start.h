// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/control_parts.h"
#include "core/targets/sky_moment.h"

#include <optional>
#include <vector>

namespace boresight::sources {

// The axis position at the start of the way `way`. Of the wraps that have room for the whole way, the one nearest to
// the place where the axes can stop is chosen. Empty if no wrap has room, or if the way is empty.
[[nodiscard]] std::optional<AxisPosition> roomyStart(const ControlParts& view,
                                                     const std::vector<targets::SkyMoment>& way);

}  // namespace boresight::sources
