// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

// A place on the Earth: geodetic latitude and longitude on the ellipsoid of WGS-84, as maps and GPS receivers give
// them. The height is the one above it; one above sea level differs by up to 100 m, which is below what the Sun, the
// Moon and the magnetic field can show.
namespace boresight {

struct Site
{
    Angle latitude;   // north positive
    Angle longitude;  // east positive
    double heightMetres = 0.0;

    bool operator==(const Site&) const = default;
};

}  // namespace boresight
