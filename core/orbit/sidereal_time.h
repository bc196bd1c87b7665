// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/julian_date.h"

// The angle between the rotating Earth and the frame of the elements. Pure.
namespace boresight::orbit {

// Greenwich mean sidereal time of 1982 in radians, [0, 2π). UTC is used for UT1. TEME uses mean, not apparent sidereal
// time. (Aoki et al., Astronomy and Astrophysics 105, 1982; AIAA 2006-6753, appendix C.)
[[nodiscard]] double siderealTime(const JulianDate& date);

}  // namespace boresight::orbit
