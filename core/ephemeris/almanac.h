// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/site.h"
#include "core/units/sky.h"

#include <array>
#include <cstdint>
#include <optional>

// Where the Sun and the Moon stand, seen from one site: the true direction of the centre of the disc, airless
// (refraction.h bends it), for any UTC of the years 1900 to 2100. The sums are those of the IAU standards in the ERFA
// library. An object remembers for a minute how the Earth's axis stands and how the bodies go, so it belongs to one
// thread.
// How exact it is: README.md.
namespace boresight::ephemeris {

enum class Body
{
    Sun,
    Moon
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

private:
    using Vector = BodyMotion::Vector;
    struct Minute
    {
        std::int64_t number = 0;
        double toDate[3][3] = {};  // from the celestial frame to the true equator and equinox of its middle
        double origins = 0.0;      // radians from the equinox to where the Earth's turning is counted from
        std::array<std::optional<BodyMotion>, 2> bodies;
    };
    [[nodiscard]] Minute& minuteOf(UtcTime utc);
    [[nodiscard]] Vector celestial(Body body, UtcTime utc);  // from the Earth's centre, kilometres

    Vector m_site;                   // kilometres, fixed to the Earth
    std::array<Vector, 3> m_ground;  // east, north and up there
    std::optional<Minute> m_minute;
};

}  // namespace boresight::ephemeris
