// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <cstdint>
#include <optional>

// How often the motor of an axis was switched on, and reversed, by the rotator for our orders. Plain value.
namespace boresight {

struct MotorStarts
{
    int lastMinute = 0;
    std::uint64_t total = 0;       // since the program connected the mount
    std::optional<Angle> coast{};  // that it goes on beyond its target, as measured

    bool operator==(const MotorStarts&) const = default;
};

}  // namespace boresight
