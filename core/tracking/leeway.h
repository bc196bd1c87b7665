// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

// How far beside its set-point an axis may be sent, which stands only at steps. A motor that is only switched on and
// off starts seldom if its axis may stand beside the set-point. Plain value.
namespace boresight::tracking {

struct Leeway
{
    TravelRange
        within;    // targets have to be in it. All of it is permitted with each position of the other axis in its range
    Angle rest;    // where the set-point stops if it brakes from this tick on
    Angle band{};  // the axis may stand this far from `rest`; 0: it has to be there
    Angle lead{};  // it may be sent this far beyond `rest`, with the sign of its motion
    bool follows = false;  // a target that is tracked, and where all around is free
    Angle halfBeam{};      // of the antenna, while it follows
    bool operator==(const Leeway&) const = default;
};

}  // namespace boresight::tracking
