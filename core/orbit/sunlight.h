// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ephemeris/almanac.h"
#include "core/orbit/topocentric.h"

// Whether the Sun shines on a satellite: the shadow of the Earth as a cone, with the half shadow around it. The Earth
// is a sphere of its equatorial radius without air, which moves the edges by some seconds. Pure. (Montenbruck, Gill:
// Satellite Orbits, 3.4.2.)
namespace boresight::orbit {

enum class Sunlight
{
    Sunlit,
    HalfShadow,
    Eclipsed
};

// Both Earth-fixed, km.
[[nodiscard]] Sunlight sunlight(const Vector& satellite, const Vector& sun);

// The almanac and the observer are of one site. It costs some 50 µs, and the Sun goes 0.25° in a minute.
[[nodiscard]] Vector sunOverGround(ephemeris::Almanac& almanac, const Observer& observer, UtcTime utc);

}  // namespace boresight::orbit
