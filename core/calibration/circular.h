// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <span>

// The mean of angles on a circle: the direction of the sum of their unit vectors. Pure.
namespace boresight::calibration {

struct CircularMean
{
    Angle direction;      // 0…360°
    double length = 0.0;  // 1: all agree; 0: they point in all directions
};

[[nodiscard]] CircularMean circularMean(std::span<const Angle> angles);

}  // namespace boresight::calibration
