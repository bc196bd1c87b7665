// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <array>
#include <cstddef>

// The end switches that a mount can have: one at each end of each axis. Plain values.
namespace boresight::end_switches {

struct EndSwitch
{
    Axis axis = Axis::Azimuth;
    bool isUpper = false;  // at the end of the larger angles

    bool operator==(const EndSwitch&) const = default;
};

inline constexpr std::array<EndSwitch, 4> kEndSwitches{
    {{Axis::Azimuth, false}, {Axis::Azimuth, true}, {Axis::Elevation, false}, {Axis::Elevation, true}}};

// The index in an array for all four.
[[nodiscard]] constexpr std::size_t indexOf(const EndSwitch& one)
{
    return 2 * index(one.axis) + (one.isUpper ? 1 : 0);
}

enum class SwitchState
{
    Unread,  // it has not been read, or it cannot be read
    Free,
    Pressed
};

}  // namespace boresight::end_switches
