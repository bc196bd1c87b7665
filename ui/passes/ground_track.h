// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/passes/pass_book.h"

#include <optional>
#include <vector>

// Where a satellite stands over the Earth. The Earth is a ball for the footprint. Pure.
namespace boresight::ui {

struct GroundTrack
{
    std::vector<Site> pass;   // below the satellite, from its rise to its set
    std::vector<Site> after;  // and from then on, for an orbit, of a day at most
};

[[nodiscard]] GroundTrack groundTrackOf(const BookedPass& one, const PassBook& book);
// Empty: the elements have no answer for this time.
[[nodiscard]] std::optional<Site> placeBelow(const orbit::ElementSet& elements, UtcTime utc);
// The edge of what sees the satellite that stands above this place, at its height.
[[nodiscard]] std::vector<Site> footprintOf(const Site& below);

}  // namespace boresight::ui
