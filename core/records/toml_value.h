// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

// Texts and numbers as a TOML file has them. Pure.
namespace boresight::records {

[[nodiscard]] std::string inQuotes(std::string_view text);

// Of the numbers in a file: a millionth of an arc second. They hide the rounding between degrees and radians.
inline constexpr int kDecimals = 9;
[[nodiscard]] std::string decimal(double value);

}  // namespace boresight::records
