// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

// The result of a fit: the value and its error of one sigma. Pure.
namespace boresight::calibration {

struct Estimate
{
    Angle value;
    Angle sigma;

    bool operator==(const Estimate&) const = default;
};

}  // namespace boresight::calibration
