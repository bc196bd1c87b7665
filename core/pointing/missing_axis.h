// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/pointing_model.h"
#include "core/pointing/region.h"
#include "core/units/sky.h"

// A mount with one axis: the other one stands at 0. Nobody knows where the beam is in the angle that is missing, so
// what is forbidden for one value of it is forbidden for all. Pure.
namespace boresight::pointing {

// Around 0, wide enough not to be a slit (slits.h).
inline constexpr TravelRange kMissingAxisTravel{.min = Angle::fromDegrees(-1.0), .max = Angle::fromDegrees(1.0)};

// What is left of the region for the other axis. The limits of the missing axis are gone. A keep-out holds for all its
// angles. Without an azimuth the highest point of the horizon holds, without an elevation there is no horizon.
[[nodiscard]] Region withoutAxis(Region region, Axis missing);

// The terms that need nothing of the missing axis: the zero point of the other one, and what gravity does to an
// elevation. Tilt, collimation and non-perpendicularity move one angle by the other, which is not known.
[[nodiscard]] PointingTerms withoutAxis(const PointingTerms& terms, Axis missing);

// The nearest that the beam can be to `place`, whatever its missing angle is.
[[nodiscard]] Angle leastAngleBetween(const SkyPointing& beam, const SkyPointing& place, Axis missing);

}  // namespace boresight::pointing
