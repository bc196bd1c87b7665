// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ephemeris/almanac.h"
#include "core/orbit/topocentric.h"

// Whether the Sun shines on a satellite: the shadow of the Earth is a cone with the half shadow around it. The Earth is
// a sphere of its equatorial radius without air, which shifts the edges by some seconds. Pure. (Montenbruck, Gill:
// Satellite Orbits, 3.4.2.)
namespace boresight::orbit {

enum class Sunlight
{
    Sunlit,
    HalfShadow,
    Eclipsed
};

// Both arguments are Earth-fixed, in km.
[[nodiscard]] Sunlight sunlight(const Vector& satellite, const Vector& sun);

// The Earth-fixed position of the Sun. The almanac and the observer must be of the same site. A call costs about 50 µs,
// and the Sun moves 0.25° in a minute.
[[nodiscard]] Vector sunOverGround(ephemeris::Almanac& almanac, const Observer& observer, UtcTime utc);

}  // namespace boresight::orbit
