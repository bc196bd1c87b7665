// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/orbit_state.h"
#include "core/orbit/turn.h"

// Converts the mean elements of one moment to position and velocity: the periodics of J3 and J2 and Kepler's equation.
// Units of MeanOrbit. (Spacetrack Report 3, section 6, from the long-period terms on; AIAA 2006-6753.)
namespace boresight::orbit {

// Factors of the periodics that depend on the inclination. Near the Earth they are constant.
struct Tilt
{
    explicit Tilt(const Turn& inclination);

    Turn inclination;
    double radial = 0.0;         // 3 cos²i - 1
    double sinSquare = 0.0;      // 1 - cos²i
    double along = 0.0;          // 7 cos²i - 1
    double longPerigee = 0.0;    // factor of e sin ω in the term of J3
    double longLongitude = 0.0;  // factor of the longitude in the term of J3
};

struct MomentElements
{
    double axis = 0.0;
    double eccentricity = 0.0;
    double node = 0.0;
    double perigee = 0.0;
    double anomaly = 0.0;
};

[[nodiscard]] OrbitResult osculatingState(const MomentElements& mean, const Tilt& tilt);

}  // namespace boresight::orbit
