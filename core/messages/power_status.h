// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <optional>

// What the drives take from their supply, and what a motion has cost.
namespace boresight {

struct MotionEnergy
{
    double joules = 0.0;  // negative: more was fed back than taken
    double peak = 0.0;    // W, of all drives together
    Seconds time{};       // that it took
    Seconds unknown{};    // of that, without reports of the power of every drive: not in `joules`
};

struct PowerStatus
{
    std::optional<double> total;  // W, of all drives; empty: one does not report it now
    std::optional<MotionEnergy> running;
    std::optional<MotionEnergy> last;  // the motion before
};

}  // namespace boresight
