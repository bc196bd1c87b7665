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
    double gain = 0.0;  // of the axis by the set-point: 1 is perfect
    Angle phase;        // of the axis to the set-point: negative is behind

    bool operator==(const SweepPoint&) const = default;
};

// Both are fitted as a wave of this frequency on a straight line. An error where the samples hold less than a period
// and a half, or the set-point hardly swings.
[[nodiscard]] Result<SweepPoint> sweepPoint(Samples samples, double hertz);

}  // namespace boresight::response
