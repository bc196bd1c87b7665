// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/region.h"

#include <optional>
#include <vector>

// The Sun as a part of the sky that the beam stays out of: a dish gathers its heat in the feed, a low-noise receiver
// hears nothing beside it. As a KeepOut of the Region it holds for every source of motion, for places, ways and what
// the axes sweep in between, like a mast does; it only has to be renewed as the Sun moves (a degree in four minutes).
// Pure.
namespace boresight::pointing {

// The smallest part of the sky between two azimuths and two elevations that holds the circle of this radius, up to 90°,
// around the Sun. A circle that reaches the zenith takes all azimuths. Empty while the Sun is down: below -2°, so that
// refraction, its disc and a site above the horizon's plain do not matter.
[[nodiscard]] std::optional<KeepOut> sunKeepOut(const SkyPointing& sun, Angle radius);

// Every place that the Sun can have at this latitude, on any day and at any hour, with the circle of this radius around
// it: where no clock is set. In parts that overlap.
[[nodiscard]] std::vector<KeepOut> sunBand(Angle latitude, Angle radius);

// What was drawn, and what is forbidden for the Sun besides.
[[nodiscard]] Region withSun(const Region& drawn, const std::vector<KeepOut>& sun);

}  // namespace boresight::pointing
