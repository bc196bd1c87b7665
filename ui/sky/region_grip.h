// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/region.h"
#include "ui/sky/sky_limits.h"
#include "ui/sky/sky_projection.h"

#include <QPointF>

#include <optional>

// The parts of the region of the profile that can be dragged, and which of them is under a pixel of the plot. Pure
// values.
namespace boresight::ui {

enum class RegionPart
{
    AzimuthMin,
    AzimuthMax,
    ElevationMin,
    ElevationMax,
    HorizonPoint,
    KeepOut
};

// The sides of a keep-out that move with the pointer: one for an edge, two for a corner, all for the whole.
struct KeepOutSides
{
    bool from = false;
    bool to = false;
    bool min = false;
    bool max = false;

    bool operator==(const KeepOutSides&) const = default;
};

struct Grip
{
    RegionPart part = RegionPart::HorizonPoint;
    std::size_t index = 0;  // of the horizon point or keep-out
    KeepOutSides sides{};   // of a keep-out

    bool operator==(const Grip&) const = default;
};

// `reach` is in pixels. Points have priority over edges, and edges over areas.
[[nodiscard]] std::optional<Grip> gripAt(const pointing::Region& region, const Travel& travel, const SkyProjection& sky,
                                         QPointF pixel, double reach);

// The length of the mark of an azimuth limit while the whole circle is permitted.
inline constexpr Angle kLimitMark = 10_deg;

}  // namespace boresight::ui
