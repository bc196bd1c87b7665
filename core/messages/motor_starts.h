// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <cstdint>

// How often the motor of an axis was switched on: by our orders, and as far as its places show it. Each start wears the
// relay and the motor. Plain value.
namespace boresight {

struct MotorStarts
{
    std::uint64_t total = 0;  // since the mount was connected
    int lastMinute = 0;
    int most = 0;        // in a minute
    bool waits = false;  // the next one waits for that
    Angle deadBand{};    // it starts when a target that moves is this far away

    bool operator==(const MotorStarts&) const = default;
};

}  // namespace boresight
