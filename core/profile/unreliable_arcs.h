// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/sensor_settings.h"

#include <string>
#include <vector>

// Converts arcs of headings to one text and back. The text has degrees: "40-80, 350-20.5". An empty text means no arc.
// Pure.
namespace boresight::profile {

[[nodiscard]] std::string toText(const std::vector<UnreliableArc>& arcs);
[[nodiscard]] Result<std::vector<UnreliableArc>> parseArcs(const std::string& text);

}  // namespace boresight::profile
