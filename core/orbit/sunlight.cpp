// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/sunlight.h"

#include <algorithm>
#include <cmath>

namespace boresight::orbit {

namespace {

constexpr double kEarthDisc = 6378.137;  // km
constexpr double kSunDisc = 695700.0;    // km (IAU 2015, resolution B3)

// The angular radius of a ball.
double discOf(double radius, double distance)
{
    return std::asin(std::min(1.0, radius / distance));
}

}  // namespace

// Compares the discs of Earth and Sun as the satellite sees them.
Sunlight sunlight(const Vector& satellite, const Vector& sun)
{
    const Vector toSun = sun - satellite;
    const double distance = length(satellite);
    const double sunDistance = length(toSun);
    const double earthDisc = discOf(kEarthDisc, distance);
    const double sunDisc = discOf(kSunDisc, sunDistance);
    const double apart = std::acos(std::clamp(-dot(satellite, toSun) / (distance * sunDistance), -1.0, 1.0));
    if (apart >= earthDisc + sunDisc) {
        return Sunlight::Sunlit;
    }
    return apart <= earthDisc - sunDisc ? Sunlight::Eclipsed : Sunlight::HalfShadow;
}

Vector sunOverGround(ephemeris::Almanac& almanac, const Observer& observer, UtcTime utc)
{
    const ephemeris::BodyPlace place = almanac.place(ephemeris::Body::Sun, utc);
    return observer.ground(place.direction, place.kilometres);
}

}  // namespace boresight::orbit
