// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/control_parts.h"
#include "core/targets/sky_moment.h"

#include <optional>
#include <vector>

namespace boresight::sources {

// Where the axes begin a way, on the wrap nearest to where they are going that has room for all of it. Empty: no wrap
// has, or there is no way.
[[nodiscard]] std::optional<AxisPosition> roomyStart(const ControlParts& view,
                                                     const std::vector<targets::SkyMoment>& way);

}  // namespace boresight::sources
