// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <string>
#include <vector>

// Where the mount may point, beyond what the travel of its axes allows: limits of operation (mechanical angles), the
// horizon seen from the mount and named parts of the sky that the beam must stay out of. Limits count turns of the
// cable; horizon and keep-outs are directions of the beam and hold for every turn and for a beam that looks over the
// top. Plain values of the profile: what is drawn, edited and enforced is this one object.
namespace boresight::pointing {

// The beam stays at or above the line through these points, straight in azimuth and elevation, closed through north.
struct HorizonPoint
{
    Angle azimuth;  // [0°, 360°)
    Angle elevation;

    bool operator==(const HorizonPoint&) const = default;
};

// The beam stays out of this part of the sky; its edge is permitted.
struct KeepOut
{
    std::string name;
    Angle azimuthFrom;  // [0°, 360°), clockwise to azimuthTo; from 350° to 10° passes through north
    Angle azimuthTo;
    Angle elevationMin;
    Angle elevationMax;

    bool operator==(const KeepOut&) const = default;
};

struct Region
{
    // Wider than the travel: the travel alone counts.
    TravelRange azimuth{.min = Angle::fromDegrees(-3600.0), .max = Angle::fromDegrees(3600.0)};
    TravelRange elevation{.min = Angle::fromDegrees(-3600.0), .max = Angle::fromDegrees(3600.0)};
    std::vector<HorizonPoint> horizon;  // by azimuth, each azimuth once; empty: no horizon
    std::vector<KeepOut> keepOuts;

    bool operator==(const Region&) const = default;
};

}  // namespace boresight::pointing
