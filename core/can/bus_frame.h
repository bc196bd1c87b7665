// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/result.h"

// The checks and additions of every real bus before a frame is sent. Pure.
namespace boresight {

inline constexpr std::uint32_t kMaxExtendedId = 0x1fff'ffff;
inline constexpr std::size_t kMaxClassicPayload = 8;
// A moteus ignores this byte. A zero would begin a write subframe.
inline constexpr std::uint8_t kPaddingByte = 0x50;

// The frame padded to a legal CAN-FD length, marked extended if its identifier needs it, and without bit-rate switch if
// it is classic. Refused: an identifier of more than 29 bits, and a classic frame of more than 8 bytes.
[[nodiscard]] Result<CanFrame> readyForBus(const CanFrame& frame);

}  // namespace boresight
