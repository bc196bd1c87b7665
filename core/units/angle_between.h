// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <cmath>

// The angle between two directions on the great circle, 0…180°. Exact for small and large angles.
namespace boresight {

[[nodiscard]] inline Angle angleBetween(const SkyPointing& a, const SkyPointing& b)
{
    const double turn = (b.azimuth - a.azimuth).radians();
    const double sinA = std::sin(a.elevation.radians());
    const double cosA = std::cos(a.elevation.radians());
    const double sinB = std::sin(b.elevation.radians());
    const double cosB = std::cos(b.elevation.radians());
    const double across = std::hypot(cosB * std::sin(turn), cosA * sinB - sinA * cosB * std::cos(turn));
    return Angle::fromRadians(std::atan2(across, sinA * sinB + cosA * cosB * std::cos(turn)));
}

}  // namespace boresight
