// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"

// The mean orbit at the epoch in the units of SGP4: radians, minutes, Earth radii (WGS-72). Pure.
namespace boresight::orbit {

struct MeanOrbit
{
    double motion = 0.0;  // Brouwer's mean motion, rad/min
    double axis = 0.0;    // semi-major
    double eccentricity = 0.0;
    double inclination = 0.0;
    double node = 0.0;
    double perigee = 0.0;
    double anomaly = 0.0;
    double bstar = 0.0;
    double sinInclination = 0.0;
    double cosInclination = 1.0;
    double roundness = 1.0;  // 1 - e²

    [[nodiscard]] double perigeeRadius() const { return axis * (1.0 - eccentricity); }
    [[nodiscard]] double parameter() const { return axis * roundness; }  // semi-latus rectum
};

// Element sets contain Kozai's mean motion. Brouwer's is computed from it. (Spacetrack Report 3, section 6.)
[[nodiscard]] MeanOrbit meanOrbitOf(const ElementSet& elements);

// How fast the oblateness of the Earth (J2 and J4) turns the orbit, rad/min. (Spacetrack Report 3, section 6.)
struct SecularRates
{
    double anomaly = 0.0;  // includes the mean motion
    double perigee = 0.0;
    double node = 0.0;
    double nodeByJ2 = 0.0;  // the part of the node rate that is of first order
};

[[nodiscard]] SecularRates secularRates(const MeanOrbit& orbit);

}  // namespace boresight::orbit
