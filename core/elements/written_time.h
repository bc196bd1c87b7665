// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/julian_date.h"

#include <optional>
#include <string_view>

// UTC as people and programs write it into lists of times. Pure.
namespace boresight::orbit {

// As parseIsoEpoch(), and also without seconds, the day alone for its midnight, +00:00 in place of the Z, or Unix
// seconds of the years 1973 to 2198. In a leap second the fraction is 1 or more.
[[nodiscard]] std::optional<JulianDate> parseWrittenTime(std::string_view text);

}  // namespace boresight::orbit
