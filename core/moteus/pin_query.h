// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/codec.h"

#include <array>
#include <cstdint>
#include <optional>

// The pins of both aux ports, as inputs and as outputs. Bit 0 is pin 0. Pure, any thread.
namespace boresight::moteus {

using PinBits = std::array<std::uint8_t, 2>;  // of port 1 and 2

// Our source ids for these queries. Their replies must not be taken for replies to the commands of kHostId.
inline constexpr std::uint8_t kPinHostId = 0x11;
inline constexpr std::uint8_t kOutputHostId = 0x12;

// The states of the pins. A pin that is not configured as an input or output reads 0.
[[nodiscard]] const Query& pinQuery();
// Empty if the reply does not contain both ports.
[[nodiscard]] std::optional<PinBits> pinsIn(const Reply& reply);

// The outputs, as they were written last (SetOutputs). A pin drives its bit only if its mode is digital_out.
[[nodiscard]] const Query& outputQuery();
[[nodiscard]] std::optional<PinBits> outputsIn(const Reply& reply);
// The value of aux1.pins.0.mode for an output.
inline constexpr int kDigitalOutput = 15;

}  // namespace boresight::moteus
