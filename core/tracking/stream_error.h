// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <optional>

// How well the points of a stream show where its target is between them. A value.
namespace boresight::tracking {

struct StreamError
{
    Angle step;                     // from the point before the last to the last, on the sky
    std::optional<Angle> foretold;  // rms error of the followed path at the next point; empty: no path is judged yet

    bool operator==(const StreamError&) const = default;
};

}  // namespace boresight::tracking
