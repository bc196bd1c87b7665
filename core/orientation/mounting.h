// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

// How the sensor sits on the antenna. Plain values.
namespace boresight::orientation {

// Which way the heading grows, seen from above: the sensor may be mounted face down.
enum class Sense
{
    Clockwise,  // with the compass
    CounterClockwise
};

struct Mounting
{
    Sense sense = Sense::Clockwise;
    Angle azimuthOffset;    // true azimuth of the beam where the sensor looks north
    Angle elevationOffset;  // elevation of the beam where the sensor says 0°

    bool operator==(const Mounting&) const = default;
};

}  // namespace boresight::orientation
