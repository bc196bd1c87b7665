// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/response/samples.h"

// How an axis follows a set-point that swings to and fro at one frequency. Pure.
namespace boresight::response {

struct SweepPoint
{
    double hertz = 0.0;
    Angle amplitude;    // of the set-point
    double gain = 0.0;  // amplitude of the axis divided by that of the set-point: 1 is perfect
    Angle phase;        // of the axis against the set-point; negative: behind

    bool operator==(const SweepPoint&) const = default;
};

// Fits a wave of this frequency on a straight line to the set-point and to the axis. An error if the samples have less
// than one and a half periods, or if the set-point hardly swings.
[[nodiscard]] Result<SweepPoint> sweepPoint(Samples samples, double hertz);

}  // namespace boresight::response
