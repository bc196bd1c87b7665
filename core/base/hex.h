// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Bytes as hexadecimal text: two digits per byte without separators.
namespace boresight {

enum class HexCase
{
    Lower,
    Upper,
};

[[nodiscard]] std::string toHex(std::span<const std::uint8_t> bytes, HexCase letters = HexCase::Lower);

// Accepts both cases. Empty for an odd number of digits or any other character. An empty text gives no bytes.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> parseHex(std::string_view digits);

}  // namespace boresight
