// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/region.h"

#include <optional>
#include <vector>

// The Sun as a keep-out: a dish focuses its heat on the feed, and a low-noise receiver receives nothing near it. As a
// KeepOut of the Region it applies to every source of motion, to positions, routes and everything in between, like a
// mast. It only must be renewed as the Sun moves (one degree in four minutes). Pure.
namespace boresight::pointing {

// The smallest range of azimuths and elevations that contains the circle of this radius (up to 90°) around the Sun. A
// circle that reaches the zenith takes all azimuths. Empty while the Sun is below -2°. That margin covers refraction,
// the size of the Sun and a site above its surroundings.
[[nodiscard]] std::optional<KeepOut> sunKeepOut(const SkyPointing& sun, Angle radius);

// All places that the Sun can have at this latitude on any day and at any hour, with the circle of this radius. For a
// computer whose clock is not set. The parts overlap.
[[nodiscard]] std::vector<KeepOut> sunBand(Angle latitude, Angle radius);

// The drawn region with the keep-outs for the Sun added.
[[nodiscard]] Region withSun(const Region& drawn, const std::vector<KeepOut>& sun);

}  // namespace boresight::pointing
