// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/degrees_text.h"
#include "core/units/sky.h"

#include <cmath>

// Azimuth and elevation as people read them: "335.00° 55.00°".
namespace boresight {

[[nodiscard]] inline QString directionText(const SkyPointing& direction)
{
    return degreesText(direction.azimuth, 2) + QStringLiteral(" ") + degreesText(direction.elevation, 2);
}

// A direction counts no turns: "315.0° / 10.0°", never -45° and never 360°.
[[nodiscard]] inline QString beamText(const SkyPointing& beam)
{
    const Angle azimuth = Angle::fromDegrees(std::round(beam.azimuth.degrees() * 10.0) / 10.0).wrapped360();
    return QStringLiteral("%1 / %2").arg(degreesText(azimuth), degreesText(beam.elevation));
}

[[nodiscard]] inline QString placeText(const AxisPosition& place)
{
    return degreesText(place.azimuth, 2) + QStringLiteral(" ") + degreesText(place.elevation, 2);
}

}  // namespace boresight
