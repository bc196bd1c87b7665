// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"

#include <cstdint>
#include <span>

namespace boresight::moteus {

// Gives one frame, however damaged, to everything that reads frames, and aborts if a promise is broken: what is read
// completely writes back byte for byte, a served reply has a legal length, words come out for every frame. Shared by
// the seeded mutation test and tests/fuzz.
void exercise(const CanFrame& frame);

// Four bytes of identifier, then at most 64 of payload.
[[nodiscard]] CanFrame frameFromBytes(std::span<const std::uint8_t> bytes);

}  // namespace boresight::moteus
