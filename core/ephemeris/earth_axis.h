// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <array>
#include <cstdint>
#include <optional>

// How the Earth stands in space: turns what is at rest among the stars into the frame that is fixed to the Earth. UT1
// is taken as UTC, which is never wrong by more than 0.9 s; the pole as standing still. An object remembers for
// ten minutes how the axis stands, so it belongs to one thread.
namespace boresight::ephemeris {

class EarthAxis
{
public:
    using Vector = std::array<double, 3>;

    // From the celestial frame: GCRF. ICRF and EME2000 have the same axes to 0.02″.
    [[nodiscard]] Vector ofTheEarth(const Vector& celestial, UtcTime utc);
    // From the true equator and equinox of this time: TOD.
    [[nodiscard]] Vector ofTheEarthFromDate(const Vector& ofDate, UtcTime utc);

private:
    struct Stand
    {
        std::int64_t number = 0;   // of the ten minutes
        double toDate[3][3] = {};  // from the celestial frame to the true equator and equinox of their middle
        double origins = 0.0;      // radians from the equinox to where the Earth's turning is counted from
    };
    [[nodiscard]] Stand& standAt(UtcTime utc);

    std::optional<Stand> m_stand;
};

}  // namespace boresight::ephemeris
