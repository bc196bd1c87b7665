// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/julian_date.h"

#include <optional>
#include <string_view>

// Reads UTC as people and programs write it in lists of times. Pure.
namespace boresight::orbit {

// Accepts what parseIsoEpoch() accepts, and also a time without seconds, a date alone (midnight), +00:00 instead of the
// Z, and Unix seconds of the years 1973 to 2198. In a leap second the fraction is 1 or more.
[[nodiscard]] std::optional<JulianDate> parseWrittenTime(std::string_view text);

}  // namespace boresight::orbit
