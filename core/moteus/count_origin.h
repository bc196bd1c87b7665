// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <cstdint>
#include <optional>
#include <string_view>

// The origin of a drive's position count. Besides the position that can be set (`d exact`, `d nearest`, registers 0x130
// and 0x131) a drive has a relative position that nobody can set: it is 0 at power-up and counts on from there. The
// difference of the two stays exactly the same, also while the axis moves, until somebody sets the position. Pure.
// Turns of the drive.
namespace boresight::moteus {

// The telemetry channel that contains both positions, in the binary format.
inline constexpr const char* kMotorPositionChannel = "motor_position";

struct CountOrigin
{
    // Changes when the encoder settings of the drive were changed, so that it began to count again. Starts again at
    // power-up.
    std::uint32_t beginning = 0;
    MotorTurns offset;  // position minus relative position

    bool operator==(const CountOrigin&) const = default;
};

// From the data of that channel. Empty if the firmware has another layout, or while the drive has no valid position:
// data that cannot be read proves nothing.
[[nodiscard]] std::optional<CountOrigin> countOrigin(std::string_view data);

}  // namespace boresight::moteus
