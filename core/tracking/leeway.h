// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

// How freely an axis that runs by itself may be sent: a motor that is only switched on and off should start seldom, so
// its axis stands beside its set-point as long as that does no harm. Plain value.
namespace boresight::tracking {

struct Leeway
{
    TravelRange within;  // permitted wherever in its own part the other axis is; the set-point and the axis are in it
    Angle rest;          // there the set-point comes to rest if it brakes from now on
    Angle band{};        // the axis may stand this far from there; 0: it has to be there
    Angle lead{};        // beyond there it may be sent, with the sign of its motion
    Angle halfBeam{};    // of the antenna, while it follows a target that moves; else 0

    [[nodiscard]] bool follows() const { return halfBeam > Angle{}; }
    bool operator==(const Leeway&) const = default;
};

}  // namespace boresight::tracking
