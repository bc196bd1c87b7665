// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/region_marks.h"

#include "ui/kit/theme.h"

#include <QPainter>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr double kGripSize = 8.0;  // px

QPen dashed()
{
    return QPen(currentTheme().accent, 2.0, Qt::DashLine);
}

void drawGrip(QPainter& painter, QPointF at, bool selected)
{
    const QRectF box(at.x() - kGripSize / 2.0, at.y() - kGripSize / 2.0, kGripSize, kGripSize);
    painter.setPen(QPen(currentTheme().accent, 1.5));
    painter.setBrush(selected ? currentTheme().accent : currentTheme().plotGround);
    painter.drawRect(selected ? box.adjusted(-2, -2, 2, 2) : box);
}

}  // namespace

void RegionMarks::paintChanges(QPainter& painter, const pointing::Region& inForce) const
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(dashed());
    if (m_edited.horizon != inForce.horizon) {
        painter.drawPath(horizonLine(m_edited.horizon, m_sky));
    }
    paintLimits(painter, inForce);
    paintKeepOuts(painter, inForce.keepOuts);
}

void RegionMarks::paintLimits(QPainter& painter, const pointing::Region& inForce) const
{
    const Travel before = permitted(inForce, m_travel);
    const Travel after = permitted(m_edited, m_travel);
    const Angle level = m_travel.level();
    for (const auto& [was, is] :
         {std::pair(before.azimuth.min, after.azimuth.min), std::pair(before.azimuth.max, after.azimuth.max)}) {
        if (was != is) {
            painter.drawPath(meridian(is, level, level + 90_deg, m_travel.pointing, m_sky));
        }
    }
    for (const auto& [was, is] :
         {std::pair(before.elevation.min, after.elevation.min), std::pair(before.elevation.max, after.elevation.max)}) {
        if (was != is && is <= level + 90_deg) {
            painter.drawPath(ring(is, m_travel.pointing, m_sky));
        }
    }
}

// New and moved keep-outs are dashed. A keep-out to be removed is crossed out.
void RegionMarks::paintKeepOuts(QPainter& painter, const std::vector<pointing::KeepOut>& inForce) const
{
    for (const pointing::KeepOut& keepOut : m_edited.keepOuts) {
        if (std::ranges::find(inForce, keepOut) == inForce.end()) {
            painter.drawPath(outline(sectorOf(keepOut), m_sky));
        }
    }
    for (const pointing::KeepOut& keepOut : inForce) {
        if (std::ranges::find(m_edited.keepOuts, keepOut.name, &pointing::KeepOut::name) == m_edited.keepOuts.end()) {
            painter.drawLine(m_sky.toPixel({keepOut.azimuthFrom, keepOut.elevationMin}),
                             m_sky.toPixel({keepOut.azimuthTo, keepOut.elevationMax}));
            painter.drawLine(m_sky.toPixel({keepOut.azimuthFrom, keepOut.elevationMax}),
                             m_sky.toPixel({keepOut.azimuthTo, keepOut.elevationMin}));
        }
    }
}

void RegionMarks::paintLimitGrips(QPainter& painter, const std::optional<Grip>& selected) const
{
    const auto isSelected = [&selected](RegionPart part) { return selected && selected->part == part; };
    const Travel limits = permitted(m_edited, m_travel);
    const bool wholeCircle = limits.azimuth.max - limits.azimuth.min >= 360_deg;
    const Angle level = limits.level();
    for (const auto& [part, azimuth] : {std::pair(RegionPart::AzimuthMin, limits.azimuth.min),
                                        std::pair(RegionPart::AzimuthMax, limits.azimuth.max)}) {
        painter.setPen(QPen(currentTheme().accent, isSelected(part) ? 4.0 : 2.5));
        painter.drawPath(
            meridian(azimuth, level, level + (wholeCircle ? kLimitMark : kLimitMark * 0.5), limits.pointing, m_sky));
    }
    const auto southOf = [&](Angle elevation) {
        const Angle south = 180_deg - limits.pointing.terms().azimuthOffset;
        return m_sky.toPixel(limits.pointing.toSky({south, elevation}));
    };
    if (limits.elevation.max <= level + 90_deg) {
        drawGrip(painter, southOf(limits.elevation.max), isSelected(RegionPart::ElevationMax));
    }
    drawGrip(painter, southOf(limits.elevation.min), isSelected(RegionPart::ElevationMin));
}

// The limits of X and Y are curves without grips. They are typed in the panel.
void RegionMarks::paintGrips(QPainter& painter, const std::optional<Grip>& selected) const
{
    const auto isSelected = [&selected](RegionPart part, std::size_t index) {
        return selected && selected->part == part && selected->index == index;
    };
    if (!m_travel.pointing.isXY()) {
        paintLimitGrips(painter, selected);
    }
    for (std::size_t i = 0; i < m_edited.keepOuts.size(); ++i) {
        const SkySector sector = sectorOf(m_edited.keepOuts[i]);
        for (const Angle azimuth : {sector.fromAzimuth, sector.toAzimuth}) {
            for (const Angle elevation : {sector.fromElevation, sector.toElevation}) {
                drawGrip(painter, m_sky.toPixel({azimuth, elevation}), isSelected(RegionPart::KeepOut, i));
            }
        }
    }
    for (std::size_t i = 0; i < m_edited.horizon.size(); ++i) {
        const pointing::HorizonPoint& point = m_edited.horizon[i];
        drawGrip(painter, m_sky.toPixel({point.azimuth, point.elevation}), isSelected(RegionPart::HorizonPoint, i));
    }
}

}  // namespace boresight::ui
