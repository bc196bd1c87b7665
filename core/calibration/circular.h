// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <span>

// Angles have no sum: their mean is the direction of the sum of their directions. Pure.
namespace boresight::calibration {

struct CircularMean
{
    Angle direction;      // 0…360°
    double length = 0.0;  // 1: all agree; 0: they point anywhere
};

[[nodiscard]] CircularMean circularMean(std::span<const Angle> angles);

}  // namespace boresight::calibration
