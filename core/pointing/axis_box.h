// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <algorithm>

// All positions that two independent axes can pass on the way between two positions. Pure value.
namespace boresight::pointing {

struct AxisBox
{
    TravelRange azimuth;
    TravelRange elevation;

    [[nodiscard]] static AxisBox at(const AxisPosition& place) { return between(place, place); }
    [[nodiscard]] static AxisBox between(const AxisPosition& a, const AxisPosition& b)
    {
        return {.azimuth = {std::min(a.azimuth, b.azimuth), std::max(a.azimuth, b.azimuth)},
                .elevation = {std::min(a.elevation, b.elevation), std::max(a.elevation, b.elevation)}};
    }
    bool operator==(const AxisBox&) const = default;
};

}  // namespace boresight::pointing
