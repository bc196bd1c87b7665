// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/orientation.h"
#include "core/units/quantity.h"

// How the sensor is mounted on the antenna. Plain values.
namespace boresight::orientation {

// The sense in which the heading grows, seen from above. It is reversed if the sensor is mounted face down.
enum class Sense
{
    Clockwise,  // like a compass
    CounterClockwise
};

// How the sensor's elevation changes when the beam rises. A sensor behind the boom reports 180° - elevation. That is
// Down with an offset of 180°.
enum class ElevationSense
{
    Up,
    Down
};

struct Mounting
{
    Sense sense = Sense::Clockwise;
    ElevationSense elevationSense = ElevationSense::Up;
    Angle azimuthOffset;    // true azimuth of the beam when the sensor points north
    Angle elevationOffset;  // elevation of the beam when the sensor reports 0°

    bool operator==(const Mounting&) const = default;
};

// Converts the elevation so that it grows when the beam rises. The zeros of a dead sensor stay unchanged.
[[nodiscard]] Orientation asMounted(Orientation value, ElevationSense sense, Angle declinationInSensor);

}  // namespace boresight::orientation
