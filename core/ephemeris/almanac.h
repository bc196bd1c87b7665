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
// library. An object remembers the orientation of the Earth's axis for a minute, so it belongs to one thread.
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

class Almanac
{
public:
    explicit Almanac(const Site& site);

    [[nodiscard]] BodyPlace place(Body body, UtcTime utc);

private:
    using Vector = std::array<double, 3>;
    struct EarthAxis
    {
        std::int64_t minute = 0;
        double toDate[3][3] = {};  // from the celestial frame to the true equator and equinox of that minute
    };
    void followEarthAxis(UtcTime utc);

    Vector m_site;                   // kilometres, fixed to the Earth
    std::array<Vector, 3> m_ground;  // east, north and up there
    std::optional<EarthAxis> m_earthAxis;
};

}  // namespace boresight::ephemeris
