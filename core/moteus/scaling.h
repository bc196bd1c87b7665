// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/registers.h"

#include <cstdint>

// Physical value <-> the 1, 2 or 4 bytes on the wire. Integers count steps that depend on the kind; the most negative
// integer stands for NaN ("unset"), finite values saturate at plus or minus the largest positive one. Both sides
// truncate towards zero: the client computes in double, the drive in single precision, so 0.29 rev as i8 can travel
// as 28 steps. Use Resolution::Float for everything that matters.
namespace boresight::moteus {

// Whose arithmetic is imitated. The device also wraps integers and counters where the client saturates.
enum class Side : std::uint8_t
{
    Client,
    Device,
};

// The low sizeInBytes(resolution) bytes of the result go on the wire, least significant first.
[[nodiscard]] std::uint32_t toWire(double value, Kind kind, Resolution resolution, Side side = Side::Client);
[[nodiscard]] double fromWire(std::uint32_t bits, Kind kind, Resolution resolution, Side side = Side::Client);

// Size of one integer step in units of the kind; 1 for unscaled kinds and for Float.
[[nodiscard]] double stepSize(Kind kind, Resolution resolution);

}  // namespace boresight::moteus
