// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sky/region_grip.h"

class QPainter;

// Draws the region of the profile on the plot while it is edited. Must not outlive its arguments.
namespace boresight::ui {

class RegionMarks
{
public:
    RegionMarks(const pointing::Region& edited, const Travel& travel, const SkyProjection& sky)
        : m_edited(edited), m_travel(travel), m_sky(sky)
    {}

    // The differences from the region in effect, dashed.
    void paintChanges(QPainter& painter, const pointing::Region& inForce) const;
    // The parts that can be dragged.
    void paintGrips(QPainter& painter, const std::optional<Grip>& selected) const;

private:
    void paintLimitGrips(QPainter& painter, const std::optional<Grip>& selected) const;
    void paintLimits(QPainter& painter, const pointing::Region& inForce) const;
    void paintKeepOuts(QPainter& painter, const std::vector<pointing::KeepOut>& inForce) const;

    const pointing::Region& m_edited;
    const Travel& m_travel;
    const SkyProjection& m_sky;
};

}  // namespace boresight::ui
