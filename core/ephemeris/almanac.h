// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/ephemeris/earth_axis.h"
#include "core/units/site.h"
#include "core/units/sky.h"

#include <array>
#include <cstdint>
#include <optional>

// The directions of Sun, Moon, planets and stars at one site: the true direction of the centre of the disc, without
// refraction (refraction.h adds it), for any UTC of the years 1900 to 2100. The algorithms are those of the IAU
// standards in the ERFA library. An object keeps the motion of the bodies for a minute and the orientation of the
// Earth's axis for ten minutes, so it belongs to one thread. README.md has the accuracy.
namespace boresight::ephemeris {

enum class Body
{
    Sun,
    Moon
};

enum class Planet
{
    Mercury,
    Venus,
    Mars,
    Jupiter,
    Saturn,
    Uranus,
    Neptune
};

// A fixed position among the stars: right ascension and declination of J2000.
struct StarPlace
{
    Angle rightAscension;
    Angle declination;

    bool operator==(const StarPlace&) const = default;
};

struct BodyPlace
{
    SkyPointing direction;  // azimuth [0°, 360°) from true north
    double kilometres = 0.0;
    Angle radius;  // apparent radius of the disc

    bool operator==(const BodyPlace&) const = default;
};

// From the centre of the Earth in the celestial frame, at the middle of a minute.
struct BodyMotion
{
    using Vector = std::array<double, 3>;
    Vector place{};  // kilometres
    Vector rate{};   // km/s
};

class Almanac
{
public:
    explicit Almanac(const Site& site);

    [[nodiscard]] BodyPlace place(Body body, UtcTime utc);
    [[nodiscard]] BodyPlace place(Planet planet, UtcTime utc);
    [[nodiscard]] SkyPointing direction(const StarPlace& star, UtcTime utc);

private:
    using Vector = BodyMotion::Vector;
    struct Minute
    {
        std::int64_t number = 0;
        std::array<std::optional<BodyMotion>, 2> bodies;
        std::array<std::optional<BodyMotion>, 7> planets;
        // Around the barycentre of the Solar System, in units of the speed of light.
        std::optional<BodyMotion::Vector> earthVelocity;
    };
    [[nodiscard]] Minute& minuteOf(UtcTime utc);
    // Converts a vector in the Earth-fixed frame to the direction at the site.
    [[nodiscard]] SkyPointing directionOf(const Vector& fromSite) const;
    [[nodiscard]] BodyPlace placeOf(const BodyMotion& motion, double radius, UtcTime utc);

    Vector m_site;                   // km, Earth-fixed
    std::array<Vector, 3> m_ground;  // east, north and up at the site
    EarthAxis m_axis;
    std::optional<Minute> m_minute;
};

}  // namespace boresight::ephemeris
