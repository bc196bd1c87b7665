// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sky/region_grip.h"

#include <QString>

// The region of the profile after a part of it is dragged, added or removed. Pure values. PlotEditor supplies mouse and
// keys.
namespace boresight::ui {

[[nodiscard]] QString describe(const pointing::Region& region, const Travel& travel, const Grip& grip);

// The region after a drag from the start to the present place of the pointer. The azimuth is tracked through north and
// over several turns, so that a limit of 450° can be dragged back to 400°.
class RegionDrag
{
public:
    RegionDrag(pointing::Region start, const Travel& travel, const Grip& grip, const SkyPointing& at);

    // Angles are rounded to multiples of `snap`. The drag stops before the region becomes invalid.
    [[nodiscard]] pointing::Region to(const SkyPointing& now, Angle snap);

    [[nodiscard]] const pointing::Region& start() const { return m_start; }
    [[nodiscard]] const Grip& grip() const { return m_grip; }  // its index changes when a point passes another one

private:
    [[nodiscard]] SkyPointing inHand(const SkyPointing& place) const;
    void dragHorizonPoint(pointing::Region& region, const SkyPointing& now, Angle snap);
    void dragKeepOut(pointing::KeepOut& keepOut, const SkyPointing& now, Angle snap) const;

    pointing::Region m_start;
    Travel m_travel;
    Grip m_grip;
    std::size_t m_startIndex;
    SkyPointing m_at;
    Angle m_azimuth;  // of the pointer, unwrapped
};

// The functions that add return the index of the new row in its list. A new point changes the horizon only near it. On
// a level horizon it becomes a hill: two more points, 15° to each side, keep the rest unchanged. A sky without a
// horizon counts as level at 0°, or at the lowest elevation that the beam can reach. On a slope, or beside a nearer
// point, the line goes straight to the neighbour.
std::size_t addHorizonPoint(pointing::Region& region, const Travel& travel, const SkyPointing& at);
inline constexpr std::size_t kPointsOfAHill = 3;
inline constexpr Angle kHillFlank = Angle::fromDegrees(15.0);
std::size_t addKeepOut(pointing::Region& region, const SkyPointing& centre);
void remove(pointing::Region& region, const Grip& grip);  // removes a point or keep-out; limits stay

// The nearest multiple of `step`.
[[nodiscard]] Angle snapped(Angle angle, Angle step);

}  // namespace boresight::ui
