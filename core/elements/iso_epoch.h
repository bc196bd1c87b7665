// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/julian_date.h"

#include <optional>
#include <string_view>

// UTC in the form of CCSDS files: "2024-05-09T08:48:19.938816", or with the day of the year, "2024-130T08:48:19.9". A
// blank may replace the T, and a Z may follow. Years 1957 to 2199. (CCSDS 502.0-B-3, 7.5.10.) Pure.
namespace boresight::orbit {

[[nodiscard]] std::optional<JulianDate> parseIsoEpoch(std::string_view text);

}  // namespace boresight::orbit
