// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"
#include "core/elements/julian_date.h"

namespace boresight::fakes {

// A circular orbit at 420 km, which passes over every site below 60° of latitude several times a day.
inline orbit::ElementSet lowOrbit(UtcTime epoch, Angle node = {}, Angle anomaly = {})
{
    return {.name = "TEST ONE",
            .number = 25544,
            .epoch = orbit::julianDate(epoch),
            .revolutionsPerDay = 15.5,
            .eccentricity = 1e-4,
            .inclination = Angle::fromDegrees(51.6),
            .ascendingNode = node,
            .meanAnomaly = anomaly,
            .bstar = 1e-5};
}

}  // namespace boresight::fakes
