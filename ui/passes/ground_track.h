// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/passes/pass_book.h"

#include <optional>
#include <vector>

// The places on the Earth below a satellite. For the footprint the Earth is a sphere. Pure.
namespace boresight::ui {

struct GroundTrack
{
    std::vector<Site> pass;   // below the satellite, from its rise to its set
    std::vector<Site> after;  // after the pass, for one orbit, at most a day
};

[[nodiscard]] GroundTrack groundTrackOf(const BookedPass& one, const PassBook& book);
// Empty: the elements give no position for this time.
[[nodiscard]] std::optional<Site> placeBelow(const orbit::ElementSet& elements, UtcTime utc);
// The edge of the area that sees a satellite above this place, at its height.
[[nodiscard]] std::vector<Site> footprintOf(const Site& below);

}  // namespace boresight::ui
