// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_list.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <tl/expected.hpp>

// The fixed columns of a two-line element set (CelesTrak, "NORAD Two-Line Element Set Format"). Pure.
namespace boresight::orbit {

inline constexpr std::size_t kTleColumns = 69;

// Both lines without trailing blanks. `line` of a problem is 1 or 2.
[[nodiscard]] tl::expected<ElementSet, ElementProblem> parseTle(std::string_view first, std::string_view second);

// The sum of the digits in columns 1 to 68, where a minus counts 1, modulo 10.
[[nodiscard]] int tleChecksum(std::string_view line);

// Reads five columns. In Alpha-5 the first is a letter: A is 10, Z is 33, without I and O. "T1234" is 271234.
[[nodiscard]] std::optional<std::int64_t> tleNumber(std::string_view columns);

}  // namespace boresight::orbit
