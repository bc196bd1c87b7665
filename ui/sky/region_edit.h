// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sky/region_grip.h"

#include <QString>

// What the region of the profile becomes when a part of it is dragged, added or removed. Pure values; PlotEditor brings
// mouse and keys.
namespace boresight::ui {

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
//
// A point changes the horizon near it only. Where the horizon is level it becomes a hill: two more points, 15° beside
// it, keep the rest as it was. A sky without a horizon is level at 0°, or at the lowest elevation that the beam can
// reach. On a slope, and beside a nearer point, the line goes straight to the neighbour.
std::size_t addHorizonPoint(pointing::Region& region, const Travel& travel, const SkyPointing& at);
inline constexpr std::size_t kPointsOfAHill = 3;
inline constexpr Angle kHillFlank = Angle::fromDegrees(15.0);
std::size_t addKeepOut(pointing::Region& region, const SkyPointing& centre);
void remove(pointing::Region& region, const Grip& grip);  // of a point or keep-out; limits stay

// The nearest multiple of `step`.
[[nodiscard]] Angle snapped(Angle angle, Angle step);

}  // namespace boresight::ui
