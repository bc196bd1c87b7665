// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <array>
#include <cstdint>
#include <optional>

// The orientation of the Earth in space: converts vectors that are fixed among the stars to the Earth-fixed frame. UTC
// is used for UT1, which is wrong by at most 0.9 s, and polar motion is left out. An object keeps the orientation of
// the axis for ten minutes, so it belongs to one thread.
namespace boresight::ephemeris {

class EarthAxis
{
public:
    using Vector = std::array<double, 3>;

    // From the celestial frame GCRF. The axes of ICRF and EME2000 are the same to 0.02″.
    [[nodiscard]] Vector ofTheEarth(const Vector& celestial, UtcTime utc);
    // From the true equator and equinox of date: TOD.
    [[nodiscard]] Vector ofTheEarthFromDate(const Vector& ofDate, UtcTime utc);

private:
    struct Stand
    {
        std::int64_t number = 0;  // number of the ten-minute period
        // From the celestial frame to the true equator and equinox at the middle of the period.
        double toDate[3][3] = {};
        double origins = 0.0;  // rad: equation of the origins
    };
    [[nodiscard]] Stand& standAt(UtcTime utc);

    std::optional<Stand> m_stand;
};

}  // namespace boresight::ephemeris
