// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

// What a rotator is to do whose motors are only switched on and off, and which drives to a place by itself. Mechanical
// angles. Plain value.
namespace boresight::tracking {

struct OwnWay
{
    enum class Kind
    {
        Rests,    // no motor is started; one that runs is stopped
        Steered,  // along the set-points, as by hand: only where they are is permitted
        Drives    // to `end` by itself: all between the set-points and `end` is permitted, in whatever order
    };
    Kind kind = Kind::Rests;
    AxisPosition target;   // what is driven to, where it is now
    AxisPosition end;      // the target, or as far ahead of one that moves as it may be waited for
    bool follows = false;  // the target moves
    Angle slack{};         // the beam may be this far from a target that moves, on each axis

    bool operator==(const OwnWay&) const = default;
};

}  // namespace boresight::tracking
