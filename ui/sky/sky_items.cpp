// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_items.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/sky/sky_frame.h"
#include "ui/sky/sky_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

class SkyItems
{
    Q_DECLARE_TR_FUNCTIONS(SkyItems)
};

// Translucent, so that the colour of the sky is visible.
QColor shade()
{
    QColor colour = currentTheme().band;
    colour.setAlphaF(0.8F);
    return colour;
}

}  // namespace

void RegionItem::setRegion(const pointing::Region& region, const Travel& travel)
{
    m_sectors = sectorsOf(region, travel);
    m_horizon = region.horizon;
}

void RegionItem::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap&, const QPointF& pole, double radius,
                      const QRectF&) const
{
    const SkyProjection sky{pole, radius};
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setFont(fonts::label());
    drawSectors(*painter, sky, SectorKind::Band);
    drawHorizon(*painter, sky);
    drawSectors(*painter, sky, SectorKind::Sector);
    drawSectors(*painter, sky, SectorKind::KeepOut);
    for (const SkySector& sector : m_sectors) {
        if (const QRectF box = nameBox(sector, sky); !box.isEmpty()) {
            drawOutlinedText(*painter, box, sector.name, currentTheme().text, currentTheme().band);
        }
    }
    painter->restore();
}

// Each kind has its own hatching, because a tint alone has too little contrast.
void RegionItem::drawSectors(QPainter& painter, const SkyProjection& sky, SectorKind kind) const
{
    QColor hatching = currentTheme().secondary;
    hatching.setAlphaF(0.7F);
    for (const SkySector& sector : m_sectors) {
        if (sector.kind != kind) {
            continue;
        }
        const QPainterPath path = outline(sector, sky);
        painter.fillPath(path, shade());
        if (kind != SectorKind::Band) {
            painter.fillPath(path, QBrush(hatching, kind == SectorKind::KeepOut ? Qt::BDiagPattern : Qt::FDiagPattern));
        }
        painter.setPen(QPen(currentTheme().secondary, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(path);
    }
}

void RegionItem::drawHorizon(QPainter& painter, const SkyProjection& sky) const
{
    const QPainterPath line = horizonLine(m_horizon, sky);
    if (line.isEmpty()) {
        return;
    }
    QPainterPath below;  // odd-even fill: the area between the rim and the line
    below.addEllipse(sky.zenith, sky.radius, sky.radius);
    below.addPath(line);
    painter.fillPath(below, currentTheme().land);
    painter.setPen(QPen(currentTheme().secondary, 1.0));
    painter.drawPath(line);
}

std::vector<QRectF> RegionItem::nameBoxes(const SkyProjection& sky) const
{
    std::vector<QRectF> boxes;
    for (const SkySector& sector : m_sectors) {
        boxes.push_back(nameBox(sector, sky));
    }
    std::erase_if(boxes, [](const QRectF& box) { return box.isEmpty(); });
    return boxes;
}

// Empty: the name is not drawn.
QRectF RegionItem::nameBox(const SkySector& sector, const SkyProjection& sky) const
{
    const bool ring = sector.toAzimuth - sector.fromAzimuth >= 360_deg;
    const Angle elevation = (sector.fromElevation + sector.toElevation) * 0.5;
    const Angle azimuth = ring ? 15_deg : (sector.fromAzimuth + sector.toAzimuth) * 0.5;
    QPointF centre = sky.toPixel(sector.beam(azimuth, elevation));
    if (!m_view.contains(centre)) {
        centre = ring ? sky.toPixel({sky.toSky(m_view.center()).azimuth, elevation})
                      : (outline(sector, sky).boundingRect() & m_view).center();
    }
    QRectF box = QFontMetrics(fonts::label()).boundingRect(sector.name);
    const double thickness = (sector.toElevation - sector.fromElevation) / 90_deg * sky.radius;
    if (ring && thickness < 2.0 * box.height()) {
        return {};  // the rim would cut the word off, or the word would hide too much
    }
    box.moveCenter(centre);
    return sky.inside(box);
}

void LabelsItem::setView(const QRectF& view, bool magnified)
{
    m_view = view;
    m_magnified = magnified;
}

int LabelsItem::marginHint() const
{
    return static_cast<int>(std::ceil(SkyFrame::margin(std::min(m_view.width(), m_view.height()))));
}

void LabelsItem::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap&, const QPointF& pole, double radius,
                      const QRectF&) const
{
    painter->save();
    painter->setFont(fonts::label());
    if (m_magnified) {
        drawInside(*painter, {pole, radius});
    } else {
        painter->setPen(currentTheme().secondary);
        for (const double elevation : m_grid.elevations) {
            painter->drawText(
                SkyProjection{pole, radius}.toPixel({0_deg, Angle::fromDegrees(elevation)}) + QPointF(4.0, -3.0),
                angleText(Angle::fromDegrees(elevation), 0));
        }
    }
    painter->restore();
}

void LabelsItem::drawInside(QPainter& painter, const SkyProjection& sky) const
{
    // Away from the middle, where the markers are.
    const SkyPointing anchor = sky.toSky(m_view.center() + QPointF(-m_view.width(), m_view.height()) * 0.25);
    const auto nearest = [](const std::vector<double>& lines, Angle to, bool circle) {
        Angle best = to;
        Angle gap = 360_deg;
        for (const double line : lines) {
            const Angle away = Angle::fromDegrees(line) - to;
            if (const Angle distance = abs(circle ? away.wrapped180() : away); distance < gap) {
                gap = distance;
                best = Angle::fromDegrees(line);
            }
        }
        return best;
    };
    const Angle ray = nearest(m_grid.azimuths, anchor.azimuth, true);
    const Angle ring = nearest(m_grid.elevations, anchor.elevation, false);
    painter.setPen(currentTheme().secondary);
    for (const double elevation : m_grid.elevations) {
        const Angle angle = Angle::fromDegrees(elevation);
        painter.drawText(sky.toPixel({ray, angle}) + QPointF(4.0, -3.0), angleText(angle, m_grid.decimals));
    }
    painter.setPen(currentTheme().text);
    for (const double azimuth : m_grid.azimuths) {
        const Angle angle = Angle::fromDegrees(azimuth);
        painter.drawText(sky.toPixel({angle, ring}) + QPointF(4.0, painter.fontMetrics().ascent()),
                         SkyItems::tr("az %1").arg(angleText(angle, m_grid.decimals)));
    }
}

void drawZoomMark(QPainter& painter, const QRectF& view, double above, const SkyProjection& sky, double magnification)
{
    const double perDegree = sky.radius / 90.0;
    double length = 0.1;  // length of the scale in degrees: the longest round value within a quarter of the view
    for (const double one : {0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0}) {
        length = one * perDegree <= view.width() / 4.0 ? one : length;
    }
    painter.save();
    painter.setFont(fonts::label());
    const QFontMetricsF metrics(painter.font());
    const QString text = SkyItems::tr("MAGNIFIED ×%1").arg(magnification, 0, 'f', magnification < 10.0 ? 1 : 0);
    const QString scale = angleText(Angle::fromDegrees(length), length < 1.0 ? 1 : 0);
    const double width = std::max(metrics.horizontalAdvance(text), length * perDegree);
    const QRectF box(view.left() + 4.0, view.bottom() - above - 2.0 * metrics.lineSpacing() - 22.0, width + 12.0,
                     2.0 * metrics.lineSpacing() + 14.0);
    painter.fillRect(box, currentTheme().window);
    painter.setPen(QPen(currentTheme().accent, 2.0));
    painter.drawRect(view.adjusted(1.0, 1.0, -1.0, -1.0));
    painter.drawText(box.topLeft() + QPointF(6.0, metrics.ascent() + 2.0), text);
    const QPointF from = box.topLeft() + QPointF(6.0, metrics.lineSpacing() + 8.0);
    const QPointF to = from + QPointF(length * perDegree, 0.0);
    painter.drawLine(from, to);
    for (const QPointF& end : {from, to}) {
        painter.drawLine(end - QPointF(0.0, 3.0), end + QPointF(0.0, 3.0));
    }
    painter.drawText(from + QPointF(0.0, metrics.ascent() + 2.0), scale);
    painter.restore();
}

}  // namespace boresight::ui
