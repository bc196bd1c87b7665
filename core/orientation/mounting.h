// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/orientation.h"
#include "core/units/quantity.h"

// How the sensor sits on the antenna. Plain values.
namespace boresight::orientation {

// Which way the heading grows, seen from above: the sensor may be mounted face down.
enum class Sense
{
    Clockwise,  // with the compass
    CounterClockwise
};

// Which way the elevation of the sensor goes when the beam rises. What it says of a boom that it sits behind, 180° -
// elevation, is Down with an offset of 180°.
enum class ElevationSense
{
    Up,
    Down
};

struct Mounting
{
    Sense sense = Sense::Clockwise;
    ElevationSense elevationSense = ElevationSense::Up;
    Angle azimuthOffset;    // true azimuth of the beam where the sensor looks north
    Angle elevationOffset;  // elevation of the beam where the sensor says 0°

    bool operator==(const Mounting&) const = default;
};

// With an elevation that grows when the beam rises. What is no elevation at all, of a dead sensor, stays as it is.
[[nodiscard]] Orientation asMounted(Orientation value, ElevationSense sense, Angle declinationInSensor);

}  // namespace boresight::orientation
