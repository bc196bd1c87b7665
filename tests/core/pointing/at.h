// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

namespace boresight::pointing {

// Both angles in degrees.
inline AxisPosition at(double azimuth, double elevation)
{
    return {.azimuth = Angle::fromDegrees(azimuth), .elevation = Angle::fromDegrees(elevation)};
}

}  // namespace boresight::pointing
