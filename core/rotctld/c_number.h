// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

// Numbers as a rotctld client may write them. Hamlib reads them with scanf of C: the number ends at the first character
// that does not fit ("10.5deg" is 10.5, "50.5" as an integer is 50), hexadecimal is permitted, and at least one digit
// is required. Unlike scanf, these functions refuse NaN, infinity and overflow. Pure.
namespace boresight::rotctld {

[[nodiscard]] std::optional<double> leadingDouble(std::string_view text);
// In single precision, as Hamlib compares positions with limits: 450.000001 is 450. The first comma is a decimal
// point, because some clients print in the user's locale.
[[nodiscard]] std::optional<float> leadingPosition(std::string_view text);
[[nodiscard]] std::optional<int> leadingInteger(std::string_view text);

}  // namespace boresight::rotctld
