// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <optional>

// The power that the drives take from their supply, and the energy that a motion has used.
namespace boresight {

struct MotionEnergy
{
    double joules = 0.0;  // negative: more was fed back than taken
    double peak = 0.0;    // W, of all drives together
    Seconds time{};       // duration of the motion
    Seconds unknown{};    // the part of `time` in which a drive reported no power: not in `joules`
};

struct PowerStatus
{
    std::optional<double> total;  // W, of all drives; empty: a drive does not report its power now
    std::optional<MotionEnergy> running;
    std::optional<MotionEnergy> last;  // the motion before
};

}  // namespace boresight
