// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <cstdint>
#include <optional>
#include <string_view>

// What a drive's position counts from. Beside the position that can be set (`d exact`, `d nearest`, registers 130 and
// 131) a drive keeps one that nobody can: 0 at power-up, and counted on from there. The difference of the two stays
// exactly the same until somebody sets the position, whether the axis moves or not. Pure; turns of the drive.
namespace boresight::moteus {

// The telemetry channel that tells it, in the binary format.
inline constexpr const char* kMotorPositionChannel = "motor_position";

struct CountOrigin
{
    // Another number: the drive was given other encoder settings and began to count again. Starts again at power-up.
    std::uint32_t beginning = 0;
    MotorTurns offset;  // of the position from what was counted since the beginning

    bool operator==(const CountOrigin&) const = default;
};

// From the data of that channel. Nothing where a firmware lays it out otherwise, or while the drive has no valid
// position: what cannot be read proves nothing.
[[nodiscard]] std::optional<CountOrigin> countOrigin(std::string_view data);

}  // namespace boresight::moteus
