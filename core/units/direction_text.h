// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/degrees_text.h"
#include "core/units/sky.h"

// Azimuth and elevation as a text for people: "335.00° 55.00°". A direction has no turns: never -45° and never 360°.
namespace boresight {

[[nodiscard]] inline QString directionText(const SkyPointing& direction)
{
    return azimuthText(direction.azimuth, 2) + QStringLiteral(" ") + degreesText(direction.elevation, 2);
}

// For example "315.0° / 10.0°".
[[nodiscard]] inline QString beamText(const SkyPointing& beam)
{
    return QStringLiteral("%1 / %2").arg(azimuthText(beam.azimuth), degreesText(beam.elevation));
}

// Keeps the turn of the azimuth.
[[nodiscard]] inline QString placeText(const AxisPosition& place)
{
    return degreesText(place.azimuth, 2) + QStringLiteral(" ") + degreesText(place.elevation, 2);
}

}  // namespace boresight
