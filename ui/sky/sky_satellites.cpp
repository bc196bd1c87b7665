// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_satellites.h"

#include "ui/kit/theme.h"
#include "ui/sky/sky_text.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr double kRing = 4.0;  // px
constexpr double kGap = 4.0;

}  // namespace

QRegion SkySatellites::show(const std::vector<SatellitePlace>& places)
{
    if (places == m_places) {
        return {};
    }
    const QRegion before = region();
    m_places = places;
    rebuild();
    return before + region();
}

void SkySatellites::setSky(const SkyProjection& sky)
{
    m_sky = sky;
    rebuild();
}

// The name is on the side towards the zenith, so that it stays on the disc.
void SkySatellites::rebuild()
{
    m_marks.clear();
    const QFontMetricsF metrics(fonts::label());
    for (const SatellitePlace& place : m_places) {
        const QPointF at = m_sky.toPixel(place.direction);
        const double width = metrics.horizontalAdvance(place.name) + 4.0;
        const double left = at.x() > m_sky.zenith.x() ? at.x() - kRing - kGap - width : at.x() + kRing + kGap;
        const QRectF text(left, at.y() - metrics.height() / 2.0, width, metrics.height());
        const bool isFree =
            std::ranges::none_of(m_marks, [&](const Mark& other) { return other.text.intersects(text); });
        m_marks.push_back({.pixel = at, .name = place.name, .text = isFree ? text : QRectF()});
    }
}

QRegion SkySatellites::region() const
{
    QRegion region;
    for (const Mark& mark : m_marks) {
        const double half = kRing + 3.0;
        region += QRectF(mark.pixel - QPointF(half, half), QSizeF(2.0 * half, 2.0 * half)).toAlignedRect();
        region += mark.text.toAlignedRect().adjusted(-2, -2, 2, 2);
    }
    return region;
}

void SkySatellites::paint(QPainter& painter) const
{
    const Theme& colours = currentTheme();
    for (const Mark& mark : m_marks) {
        painter.setPen(QPen(colours.secondary, 1.6));
        painter.setBrush(colours.skyRim);
        painter.drawEllipse(mark.pixel, kRing, kRing);
        if (!mark.text.isEmpty()) {
            drawOutlinedText(painter, mark.text, mark.name, colours.secondary, colours.skyRim);
        }
    }
}

}  // namespace boresight::ui
