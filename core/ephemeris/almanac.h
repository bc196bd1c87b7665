// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/ephemeris/earth_axis.h"
#include "core/units/site.h"
#include "core/units/sky.h"

#include <array>
#include <cstdint>
#include <optional>

// Where the Sun, the Moon, the planets and the stars stand, seen from one site: the true direction of the centre of the
// disc, airless (refraction.h bends it), for any UTC of the years 1900 to 2100. The sums are those of the IAU standards
// in the ERFA library. An object remembers for a minute how the Earth's axis stands and how the bodies go, so it
// belongs to one thread. How exact it is: README.md.
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

// Among the stars: right ascension and declination of J2000. It stands still there.
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
    Angle radius;  // of the disc as it is seen

    bool operator==(const BodyPlace&) const = default;
};

// From the Earth's centre in the celestial frame, at the middle of a minute.
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
        std::optional<BodyMotion::Vector> earthVelocity;  // around the centre of mass of all, of the speed of light
    };
    [[nodiscard]] Minute& minuteOf(UtcTime utc);
    // What the site sees, of the frame of the Earth.
    [[nodiscard]] SkyPointing directionOf(const Vector& fromSite) const;
    [[nodiscard]] BodyPlace placeOf(const BodyMotion& motion, double radius, UtcTime utc);

    Vector m_site;                   // kilometres, fixed to the Earth
    std::array<Vector, 3> m_ground;  // east, north and up there
    EarthAxis m_axis;
    std::optional<Minute> m_minute;
};

}  // namespace boresight::ephemeris
