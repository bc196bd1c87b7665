// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// Converts text to numbers and back, independent of the locale. The whole text must be the number. An unreadable number
// is an error, never 0.
namespace boresight {

[[nodiscard]] std::optional<double> parseFinite(std::string_view text);
[[nodiscard]] std::optional<std::int64_t> parseInteger(std::string_view text, int base = 10);

// Fixed decimals with a point: formatFixed(12.345, 2) is "12.35"; never "-0.00".
[[nodiscard]] std::string formatFixed(double value, int decimals);

}  // namespace boresight
