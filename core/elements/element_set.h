// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/julian_date.h"
#include "core/units/quantity.h"

#include <cstdint>
#include <string>

// The mean elements of one satellite from a TLE or OMM file. They are valid only with SGP4. The frame is TEME (true
// equator, mean equinox). Pure value.
namespace boresight::orbit {

struct ElementSet
{
    std::string name;         // UTF-8; may be empty
    std::int64_t number = 0;  // in the catalogue (NORAD), up to 9 digits
    std::string designator;   // international, "1998-067A"; may be empty
    char classification = 'U';
    JulianDate epoch;                // UTC
    double revolutionsPerDay = 0.0;  // Kozai's mean motion, above 0
    double eccentricity = 0.0;       // [0, 1)
    Angle inclination;               // 0…180°
    Angle ascendingNode;
    Angle perigee;  // argument of the perigee
    Angle meanAnomaly;
    double bstar = 0.0;                // drag term, per Earth radius
    double meanMotionDot = 0.0;        // half the first derivative, rev/day²; SGP4 does not use it
    double meanMotionDoubleDot = 0.0;  // a sixth of the second derivative, rev/day³; SGP4 does not use it
    std::int64_t setNumber = 0;
    std::int64_t revolution = 0;  // at the epoch

    bool operator==(const ElementSet&) const = default;
};

inline constexpr std::int64_t kLargestNumber = 999'999'999;

}  // namespace boresight::orbit
