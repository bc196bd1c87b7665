// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/degrees_text.h"
#include "core/units/sky.h"

// Azimuth and elevation as people read them: "335.00° 55.00°".
namespace boresight {

[[nodiscard]] inline QString directionText(const SkyPointing& direction)
{
    return degreesText(direction.azimuth, 2) + QStringLiteral(" ") + degreesText(direction.elevation, 2);
}

[[nodiscard]] inline QString placeText(const AxisPosition& place)
{
    return degreesText(place.azimuth, 2) + QStringLiteral(" ") + degreesText(place.elevation, 2);
}

}  // namespace boresight
