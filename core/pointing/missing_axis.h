// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/pointing_model.h"
#include "core/pointing/region.h"
#include "core/units/sky.h"

// A mount with one axis. The angle of the missing axis is computed as 0, but the true direction of the beam in that
// angle is unknown. So a direction that is forbidden for one value of the angle is forbidden for all values. Pure.
namespace boresight::pointing {

// The travel of a missing axis: around 0°, and so wide that slits.h does not close it.
inline constexpr TravelRange kMissingAxisTravel{.min = Angle::fromDegrees(-1.0), .max = Angle::fromDegrees(1.0)};

// The part of the region that applies to the other axis. The limits of the missing axis are removed. A keep-out applies
// to all its angles. Without an azimuth the highest point of the horizon applies everywhere. Without an elevation there
// is no horizon.
[[nodiscard]] Region withoutAxis(Region region, Axis missing);

// The terms that do not depend on the missing axis: the zero point of the other axis, and the sag of an elevation.
// Tilt, collimation and non-perpendicularity shift one angle by an amount that depends on the other, which is unknown.
[[nodiscard]] PointingTerms withoutAxis(const PointingTerms& terms, Axis missing);

// The smallest possible angle between the beam and `place`, whatever the missing angle is.
[[nodiscard]] Angle leastAngleBetween(const SkyPointing& beam, const SkyPointing& place, Axis missing);

}  // namespace boresight::pointing
