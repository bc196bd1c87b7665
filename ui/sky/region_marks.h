// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sky/region_grip.h"

class QPainter;

// How the region of the profile looks on the plot while it is edited. Lives no longer than what it is made with.
namespace boresight::ui {

class RegionMarks
{
public:
    RegionMarks(const pointing::Region& edited, const Travel& travel, const SkyProjection& sky)
        : m_edited(edited), m_travel(travel), m_sky(sky)
    {}

    // What differs from what is in force, dashed.
    void paintChanges(QPainter& painter, const pointing::Region& inForce) const;
    // What can be dragged.
    void paintGrips(QPainter& painter, const std::optional<Grip>& selected) const;

private:
    void paintLimits(QPainter& painter, const pointing::Region& inForce) const;
    void paintKeepOuts(QPainter& painter, const std::vector<pointing::KeepOut>& inForce) const;

    const pointing::Region& m_edited;
    const Travel& m_travel;
    const SkyProjection& m_sky;
};

}  // namespace boresight::ui
