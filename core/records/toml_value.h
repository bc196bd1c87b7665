// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

// Texts and numbers in the form of a TOML file. Pure.
namespace boresight::records {

[[nodiscard]] std::string inQuotes(std::string_view text);

// Decimals of the numbers in a file: a millionth of an arc second. Rounding to them hides the errors of converting
// between degrees and radians.
inline constexpr int kDecimals = 9;
[[nodiscard]] std::string decimal(double value);

}  // namespace boresight::records
