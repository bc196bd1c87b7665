// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/codec.h"

#include <array>
#include <cstdint>
#include <optional>

// The states of the pins of both aux ports. Bit 0 is pin 0. A pin that is not configured as an input or output reads 0.
// Pure, any thread.
namespace boresight::moteus {

// Our source id for these queries. Their replies must not be taken for replies to the commands of kHostId.
inline constexpr std::uint8_t kPinHostId = 0x11;

[[nodiscard]] const Query& pinQuery();
// Of port 1 and 2. Empty if the reply does not contain both.
[[nodiscard]] std::optional<std::array<std::uint8_t, 2>> pinsIn(const Reply& reply);

}  // namespace boresight::moteus
