// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <string>
#include <vector>

// Where the mount may point, in addition to the travel of its axes: soft limits (mechanical angles), the horizon seen
// from the mount, and named keep-outs. Limits count turns of the cable. Horizon and keep-outs are directions of the
// beam, so they apply on every turn and over the top. Plain values of the profile: the same object is drawn, edited and
// enforced.
namespace boresight::pointing {

// The beam stays at or above the line through these points. The line is straight in azimuth and elevation and closed
// through north.
struct HorizonPoint
{
    Angle azimuth;  // [0°, 360°)
    Angle elevation;

    bool operator==(const HorizonPoint&) const = default;
};

// The beam stays out of this part of the sky. Its edge is permitted.
struct KeepOut
{
    std::string name;
    Angle azimuthFrom;  // [0°, 360°), clockwise to azimuthTo; from 350° to 10° includes north
    Angle azimuthTo;
    Angle elevationMin;
    Angle elevationMax;

    bool operator==(const KeepOut&) const = default;
};

struct Region
{
    // The defaults are wider than any travel, so only the travel limits the axes.
    TravelRange azimuth{.min = Angle::fromDegrees(-3600.0), .max = Angle::fromDegrees(3600.0)};
    TravelRange elevation{.min = Angle::fromDegrees(-3600.0), .max = Angle::fromDegrees(3600.0)};
    std::vector<HorizonPoint> horizon;  // sorted by azimuth, each azimuth once; empty: no horizon
    std::vector<KeepOut> keepOuts;

    bool operator==(const Region&) const = default;
};

}  // namespace boresight::pointing
