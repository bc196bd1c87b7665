// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky_items.h"

#include "ui/format.h"
#include "ui/sky_projection.h"
#include "ui/symbol.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace boresight::ui {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("PolarPlot", text);
}

// The outline in steps of about a degree, which no eye tells from an arc.
QPainterPath outline(const SkySector& sector, const SkyProjection& sky)
{
    const int steps = std::max(1, static_cast<int>(std::ceil((sector.toAzimuth - sector.fromAzimuth).degrees())));
    const auto azimuth = [&](int step) {
        return sector.fromAzimuth + (sector.toAzimuth - sector.fromAzimuth) * (double(step) / steps);
    };
    QPolygonF rim;
    for (int step = 0; step <= steps; ++step) {
        rim << sky.toPixel({azimuth(step), sector.fromElevation});
    }
    QPolygonF inner;
    for (int step = steps; step >= 0; --step) {
        inner << sky.toPixel({azimuth(step), sector.toElevation});
    }
    QPainterPath path;
    if (sector.toAzimuth - sector.fromAzimuth >= 360_deg) {
        path.addPolygon(rim);
        path.addPolygon(inner);  // a ring: odd-even fill leaves the middle open
    } else {
        path.addPolygon(rim + inner);
        path.closeSubpath();
    }
    return path;
}

void drawName(QPainter& painter, const SkySector& sector, const SkyProjection& sky)
{
    const bool ring = sector.toAzimuth - sector.fromAzimuth >= 360_deg;
    const Angle azimuth = ring ? 15_deg : (sector.fromAzimuth + sector.toAzimuth) * 0.5;
    const QPointF centre = sky.toPixel({azimuth, (sector.fromElevation + sector.toElevation) * 0.5});
    QRectF box = painter.fontMetrics().boundingRect(sector.name);
    box.moveCenter(centre);
    painter.fillRect(box.adjusted(-3, -1, 3, 1), currentTheme().band);
    painter.setPen(currentTheme().text);
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, sector.name);
}

QString azimuthLabel(int degrees)
{
    switch (degrees) {
        case 0:
            return tr("N");
        case 90:
            return tr("E");
        case 180:
            return tr("S");
        case 270:
            return tr("W");
        default:
            return QString::number(degrees);
    }
}

}  // namespace

void SectorsItem::setSectors(std::vector<SkySector> sectors)
{
    m_sectors = std::move(sectors);
}

void SectorsItem::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap&, const QPointF& pole, double radius,
                       const QRectF&) const
{
    const SkyProjection sky{pole, radius};
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setFont(fonts::label());
    for (const SkySector& sector : m_sectors) {
        const QPainterPath path = outline(sector, sky);
        painter->fillPath(path, currentTheme().band);
        painter->fillPath(path, QBrush(currentTheme().secondary, Qt::BDiagPattern));
        painter->setPen(currentTheme().secondary);
        painter->setBrush(Qt::NoBrush);
        painter->drawPath(path);
    }
    for (const SkySector& sector : m_sectors) {
        drawName(*painter, sector, sky);
    }
    painter->restore();
}

int LabelsItem::marginHint() const
{
    const QFontMetrics metrics(fonts::label());
    return std::max(metrics.height(), metrics.horizontalAdvance(QStringLiteral("000"))) + 4;
}

void LabelsItem::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap&, const QPointF& pole, double radius,
                      const QRectF&) const
{
    painter->save();
    painter->setFont(fonts::label());
    const QFontMetricsF metrics(painter->font());
    const SkyProjection rim{pole, radius + marginHint() / 2.0 + 1.0};
    for (int degrees = 0; degrees < 360; degrees += 30) {
        const QPointF centre = rim.toPixel({Angle::fromDegrees(degrees), 0_deg});
        QRectF box(0, 0, 40, metrics.height());
        box.moveCenter(centre);
        painter->setPen(degrees % 90 == 0 ? currentTheme().text : currentTheme().secondary);
        painter->drawText(box, Qt::AlignCenter, azimuthLabel(degrees));
    }
    const SkyProjection sky{pole, radius};
    painter->setPen(currentTheme().secondary);
    for (const Angle elevation : {30_deg, 60_deg}) {
        painter->drawText(sky.toPixel({0_deg, elevation}) + QPointF(4.0, -3.0), angleText(elevation, 0));
    }
    painter->restore();
}

void drawLegend(QPainter& painter, QPointF corner)
{
    const struct
    {
        Symbol symbol;
        QString text;
        Tone tone;
    } lines[] = {{Symbol::Actual, tr("actual"), Tone::Normal},
                 {Symbol::Commanded, tr("commanded"), Tone::Normal},
                 {Symbol::Target, tr("target"), Tone::Accent}};
    painter.setFont(fonts::label());
    const QFontMetricsF metrics(painter.font());
    double y = corner.y();
    for (const auto& line : lines) {
        const double size = metrics.ascent();
        drawSymbol(painter, line.symbol, QRectF(corner.x(), y + 1.0, size, size), currentTheme().colour(line.tone));
        painter.setPen(currentTheme().secondary);
        painter.drawText(QPointF(corner.x() + size * 1.5, y + metrics.ascent()), line.text);
        y += metrics.lineSpacing();
    }
}

}  // namespace boresight::ui
