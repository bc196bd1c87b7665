// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QString>

#include <vector>

// Which parts of the sky the travel of the two axes leaves out, for drawing only: the station decides what is
// permitted.
namespace boresight::ui {

// A piece of sky between two azimuths (clockwise from the first) and two elevations.
struct SkySector
{
    Angle fromAzimuth;
    Angle toAzimuth;  // unwrapped: larger than fromAzimuth
    Angle fromElevation;
    Angle toElevation;
    QString name;
};

// An axis range over the top reaches a closed azimuth sector from the other side, from the elevation 180° - max on.
[[nodiscard]] std::vector<SkySector> unreachable(const TravelRange& azimuth, const TravelRange& elevation);

}  // namespace boresight::ui
