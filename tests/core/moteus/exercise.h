// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"

#include <cstdint>
#include <span>

namespace boresight::moteus {

// Gives one frame, possibly damaged, to everything that reads frames, and aborts if a promise is broken. A frame that
// was read completely is written back byte for byte. A reply has a legal length. Every frame can be described in words.
// Used by the seeded mutation test and by tests/fuzz.
void exercise(const CanFrame& frame);

// Four bytes of identifier, then at most 64 bytes of payload.
[[nodiscard]] CanFrame frameFromBytes(std::span<const std::uint8_t> bytes);

}  // namespace boresight::moteus
