// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace boresight {

// How often the motor of an axis was switched on, as far as its places and our orders tell. Each start wears relay and
// motor. Plain value.
struct MotorStarts
{
    std::uint64_t total = 0;  // since the mount was connected
    int lastMinute = 0;

    bool operator==(const MotorStarts&) const = default;
};

}  // namespace boresight
