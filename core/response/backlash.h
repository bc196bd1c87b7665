// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/response/samples.h"

// The backlash of a gear, measured by a sensor in front of it: an axis that moves slowly to and fro needs little torque
// while it crosses the gap, and more as soon as it moves the load. Pure.
namespace boresight::response {

struct BacklashFigures
{
    Angle gap;
    Angle uncertainty;        // two standard deviations of the mean of the reversals
    double freeTorque = 0.0;  // Nm, inside the gap
    double loadTorque = 0.0;  // Nm, with the load
    int reversals = 0;        // number of reversals that showed the gap
    int tried = 0;

    bool operator==(const BacklashFigures&) const = default;
};

// From legs to and fro at one rate, with torque. The error explains why the gap cannot be measured.
[[nodiscard]] Result<BacklashFigures> backlashFigures(Samples samples);

}  // namespace boresight::response
