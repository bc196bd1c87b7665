// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <cstdint>
#include <optional>

// How often the rotator started or reversed the motor of an axis for targets of Boresight. Plain value.
namespace boresight {

struct MotorStarts
{
    int lastMinute = 0;
    std::uint64_t total = 0;       // since the program connected the mount
    std::optional<Angle> coast{};  // measured: how far the axis coasts beyond its target

    bool operator==(const MotorStarts&) const = default;
};

}  // namespace boresight
