// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/registers.h"

#include <cstdint>

// Physical value <-> the 1, 2 or 4 bytes on the bus. Integers count steps whose size depends on the kind. The most
// negative integer means NaN ("unset"). Finite values saturate at plus or minus the largest positive integer. Both
// sides truncate towards zero. The client computes in double and the drive in single precision, so 0.29 rev as i8 may
// become 28 steps. Use Resolution::Float for everything that matters.
namespace boresight::moteus {

// The side whose arithmetic is used. The device also lets integers and counters overflow where the client saturates.
enum class Side : std::uint8_t
{
    Client,
    Device,
};

// The low sizeInBytes(resolution) bytes of the result go on the bus, least significant byte first.
[[nodiscard]] std::uint32_t toWire(double value, Kind kind, Resolution resolution, Side side = Side::Client);
[[nodiscard]] double fromWire(std::uint32_t bits, Kind kind, Resolution resolution, Side side = Side::Client);

// Size of one integer step in the unit of the kind. 1 for unscaled kinds and for Float.
[[nodiscard]] double stepSize(Kind kind, Resolution resolution);

}  // namespace boresight::moteus
