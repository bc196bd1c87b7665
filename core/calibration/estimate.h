// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

// What a fit says: the value, and one sigma of what it may be off. Pure.
namespace boresight::calibration {

struct Estimate
{
    Angle value;
    Angle sigma;

    bool operator==(const Estimate&) const = default;
};

}  // namespace boresight::calibration
