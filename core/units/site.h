// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

// A place on the Earth: geodetic latitude and longitude on the ellipsoid of WGS-84, as in maps and GPS receivers. The
// height is above the ellipsoid. The height above sea level differs by up to 100 m, which has no visible effect on the
// Sun, the Moon or the magnetic field.
namespace boresight {

struct Site
{
    Angle latitude;   // north positive
    Angle longitude;  // east positive
    double heightMetres = 0.0;

    bool operator==(const Site&) const = default;
};

}  // namespace boresight
