// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/region.h"
#include "ui/sky/sky_limits.h"
#include "ui/sky/sky_projection.h"

#include <QString>

#include <optional>

// The region of the profile taken by the hand: which part of it lies under a pixel of the plot, and what it becomes
// when that part is dragged. Pure values; PlotEditor brings mouse and keys.
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

// The sides of a keep-out that move with the hand: one for an edge, two for a corner, all for the whole.
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

// `reach` in pixels. Points go before edges, edges before areas.
[[nodiscard]] std::optional<Grip> gripAt(const pointing::Region& region, const Travel& travel, const SkyProjection& sky,
                                         QPointF pixel, double reach);
[[nodiscard]] QString describe(const pointing::Region& region, const Travel& travel, const Grip& grip);

// The region as it is after the hand went from where it took hold to where it is now. The azimuth is followed through
// north and over several turns, so that a limit of 450° can be drawn back to 400°.
class RegionDrag
{
public:
    RegionDrag(pointing::Region start, const Travel& travel, const Grip& grip, const SkyPointing& at);

    // Angles become multiples of `snap`; what would be no region any more stops before it.
    [[nodiscard]] pointing::Region to(const SkyPointing& now, Angle snap);

    [[nodiscard]] const pointing::Region& start() const { return m_start; }
    [[nodiscard]] const Grip& grip() const { return m_grip; }  // its index follows a point that passes another one

private:
    [[nodiscard]] SkyPointing inHand(const SkyPointing& place) const;
    void dragHorizonPoint(pointing::Region& region, const SkyPointing& now, Angle snap);
    void dragKeepOut(pointing::KeepOut& keepOut, const SkyPointing& now, Angle snap) const;

    pointing::Region m_start;
    Travel m_travel;
    Grip m_grip;
    std::size_t m_startIndex;
    SkyPointing m_at;
    Angle m_azimuth;  // of the hand, unwrapped
};

// Each returns where the new one is in its list.
std::size_t addHorizonPoint(pointing::Region& region, const SkyPointing& at);
std::size_t addKeepOut(pointing::Region& region, const SkyPointing& centre);
void remove(pointing::Region& region, const Grip& grip);  // of a point or keep-out; limits stay

// The nearest multiple of `step`.
[[nodiscard]] Angle snapped(Angle angle, Angle step);

}  // namespace boresight::ui
