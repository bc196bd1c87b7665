// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_markers.h"

#include "ui/kit/symbol.h"
#include "ui/sky/sky_limits.h"

#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr double kActualSize = 13.0;  // px; inside the diamond, inside the cross, when all is on target
constexpr double kMarkerSize = 22.0;
constexpr double kCommandedSize = 32.0;
constexpr Angle kPathGap = 6_deg;     // three times what the fastest mount goes in one update
constexpr Angle kPathStep = 0.2_deg;  // finer than a pixel of any screen
constexpr std::chrono::minutes kPathAge{15};
constexpr std::chrono::minutes kForgetEvery{1};
constexpr std::size_t kPathLength = 20000;  // 15 minutes without rest at 4°/s
constexpr int kTextMargin = 3;

// Good enough for small angles, also near the zenith.
Angle separation(const SkyPointing& a, const SkyPointing& b)
{
    const double east = (a.azimuth - b.azimuth).wrapped180().radians() * std::cos(a.elevation.radians());
    const double up = (a.elevation - b.elevation).radians();
    return Angle::fromRadians(std::hypot(east, up));
}

QRect around(const QPointF& a, const QPointF& b)
{
    return QRectF(a, b).normalized().adjusted(-3, -3, 3, 3).toAlignedRect();
}

}  // namespace

SkyMarkers::SkyMarkers(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFont(fonts::label());
    setCursor(Qt::CrossCursor);
}

void SkyMarkers::setGround(const QPixmap& ground, const SkyProjection& projection)
{
    m_ground = ground;
    m_projection = projection;
    rebuildPath();
    rebuildWay();
    update();
}

void SkyMarkers::setMarkers(const MarkerData& markers, UtcTime utc)
{
    forgetOldPath(utc);
    if (markers == m_markers) {
        return;
    }
    const QRegion before = occupied();
    m_markers = markers;
    extendPath(utc);
    rebuildWay();
    update(before + occupied());
}

void SkyMarkers::setPicked(const std::optional<SkyPointing>& direction)
{
    const QRegion before = occupied();
    m_markers.picked = direction;
    update(before + occupied());
}

// A whole minute at a time: the path is then built anew.
void SkyMarkers::forgetOldPath(UtcTime utc)
{
    if (m_path.empty() || utc - m_path.front().utc < kPathAge + kForgetEvery) {
        return;
    }
    const auto young = std::ranges::find_if(m_path, [&](const PastPlace& one) { return utc - one.utc < kPathAge; });
    m_path.erase(m_path.begin(), young);
    rebuildPath();
    update();
}

void SkyMarkers::rebuildWay()
{
    m_wayPixels.clear();
    QPolygonF line;
    for (const SkyPointing& place : m_markers.way) {
        line << m_projection.toPixel(place);
    }
    m_wayPixels.addPolygon(line);
}

void SkyMarkers::extendPath(UtcTime utc)
{
    if (!m_markers.live || !m_markers.actual) {
        return;
    }
    const SkyPointing place = unflipped(*m_markers.actual);
    if (m_pathEnd && separation(place, *m_pathEnd) < kPathStep) {
        return;
    }
    const QPointF before = m_pathPixels.currentPosition();
    addToPath(place);
    m_path.push_back({place, utc});
    if (m_path.size() > kPathLength) {
        m_path.erase(m_path.begin(), m_path.begin() + kPathLength / 8);
        rebuildPath();
        update();
    }
    update(around(before, m_pathPixels.currentPosition()));
}

// A line is drawn only where the mount was seen to go: after silence or a new reference the path begins anew.
void SkyMarkers::addToPath(const SkyPointing& place)
{
    const QPointF pixel = m_projection.toPixel(place);
    if (m_pathEnd && separation(place, *m_pathEnd) < kPathGap) {
        m_pathPixels.lineTo(pixel);
    } else {
        m_pathPixels.moveTo(pixel);
    }
    m_pathEnd = place;
}

void SkyMarkers::rebuildPath()
{
    m_pathPixels.clear();
    m_pathEnd.reset();
    for (const PastPlace& one : m_path) {
        addToPath(one.place);
    }
}

QRectF SkyMarkers::markerBox(const SkyPointing& direction, double size) const
{
    const QPointF centre = m_projection.toPixel(direction);
    return {centre.x() - size / 2.0, centre.y() - size / 2.0, size, size};
}

double SkyMarkers::beamRadius() const
{
    return std::max(m_markers.beamWidth / 180_deg * m_projection.radius, kActualSize / 2.0 + 2.0);
}

// Where the beam is now: around the actual place; all the way up, or all around, if only one angle of it is known.
QPainterPath SkyMarkers::beamPixels() const
{
    if (m_markers.missing == Axis::Elevation) {
        return meridian(m_markers.actual->azimuth, 0_deg, 90_deg, {}, m_projection);
    }
    if (m_markers.missing == Axis::Azimuth) {
        return ring(unflipped(*m_markers.actual).elevation, {}, m_projection);
    }
    QPainterPath path;
    path.addEllipse(m_projection.toPixel(*m_markers.actual), beamRadius(), beamRadius());
    return path;
}

QRect SkyMarkers::targetLabelBox() const
{
    if (!m_markers.target || m_markers.targetLabel.isEmpty()) {
        return {};
    }
    const QRectF marker = markerBox(*m_markers.target, kMarkerSize);
    if (!QRectF(rect()).contains(marker.center())) {
        return {};  // outside the magnified part
    }
    QRect box = fontMetrics().boundingRect(m_markers.targetLabel).adjusted(-kTextMargin, 0, kTextMargin, 0);
    const double gap = std::max(beamRadius() + 4.0, kMarkerSize);
    const QPointF offsets[] = {
        {gap, -gap}, {-gap - box.width(), -gap}, {gap, gap}, {-gap - box.width(), gap}, {0, -3 * gap}, {0, 3 * gap}};
    const QPoint most(std::max(width() - box.width(), 0), std::max(height() - box.height(), 0));
    for (const QPointF& offset : offsets) {
        const QPoint corner = (marker.center() + offset).toPoint();
        box.moveTopLeft({std::clamp(corner.x(), 0, most.x()), std::clamp(corner.y(), 0, most.y())});
        if (!covers(box)) {
            break;
        }
    }
    return box;
}

// True if the box would hide where the mount is or is commanded to.
bool SkyMarkers::covers(const QRect& box) const
{
    return (m_markers.actual && markerBox(*m_markers.actual, 2.0 * beamRadius()).intersects(box)) ||
           (m_markers.commanded && markerBox(*m_markers.commanded, kCommandedSize).intersects(box));
}

QRegion SkyMarkers::occupied() const
{
    QRegion region;
    const auto add = [&region](const QRectF& box) { region += box.toAlignedRect().adjusted(-2, -2, 2, 2); };
    if (m_markers.actual) {
        add(markerBox(*m_markers.actual, kActualSize));
        region += beamPixels().boundingRect().toAlignedRect().adjusted(-3, -3, 3, 3) & rect();
    }
    if (m_markers.commanded) {
        add(markerBox(*m_markers.commanded, kCommandedSize));
    }
    if (m_markers.target) {
        add(markerBox(*m_markers.target, kMarkerSize));
        add(targetLabelBox());
    }
    if (m_markers.sensor) {
        add(markerBox(*m_markers.sensor, kMarkerSize));
    }
    if (m_markers.picked) {
        add(markerBox(*m_markers.picked, kCommandedSize));
    }
    if (m_markers.offTarget && m_markers.actual && m_markers.target) {
        region += around(m_projection.toPixel(*m_markers.actual), m_projection.toPixel(*m_markers.target));
    }
    if (!m_wayPixels.isEmpty()) {
        region += m_wayPixels.boundingRect().toAlignedRect().adjusted(-3, -3, 3, 3) & rect();
    }
    return region;
}

void SkyMarkers::paintEvent(QPaintEvent* event)
{
    QPainter painter(this);
    painter.setClipRegion(event->region());
    painter.drawPixmap(0, 0, m_ground);
    paint(painter);
}

void SkyMarkers::paint(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    const Theme& colours = currentTheme();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.secondary, 1.5));
    painter.drawPath(m_pathPixels);
    painter.setPen(QPen(colours.accent, 1.5, Qt::DashLine));
    painter.drawPath(m_wayPixels);
    if (m_markers.picked) {
        painter.setPen(QPen(colours.accent, 1.5, Qt::DashLine));
        painter.drawEllipse(markerBox(*m_markers.picked, kCommandedSize - 4.0));
    }
    if (m_markers.offTarget && m_markers.actual && m_markers.target) {
        painter.setPen(QPen(colours.warning, 2.0));
        painter.drawLine(m_projection.toPixel(*m_markers.actual), m_projection.toPixel(*m_markers.target));
    }
    if (m_markers.sensor) {
        drawSymbol(painter, Symbol::Sensor, markerBox(*m_markers.sensor, kMarkerSize), colours.sensor);
    }
    drawTarget(painter);
    if (m_markers.commanded) {
        drawSymbol(painter, Symbol::Commanded, markerBox(*m_markers.commanded, kCommandedSize), colours.text);
    }
    drawActual(painter);
}

void SkyMarkers::drawTarget(QPainter& painter) const
{
    if (!m_markers.target) {
        return;
    }
    const Theme& colours = currentTheme();
    drawSymbol(painter, Symbol::Target, markerBox(*m_markers.target, kMarkerSize), colours.accent);
    const QRect box = targetLabelBox();
    if (!box.isNull()) {
        painter.fillRect(box, colours.plotGround);
        painter.setPen(colours.accent);
        painter.drawText(box, Qt::AlignCenter, m_markers.targetLabel);
    }
}

void SkyMarkers::drawActual(QPainter& painter) const
{
    if (!m_markers.actual) {
        return;
    }
    const Theme& colours = currentTheme();
    const QColor colour = m_markers.live ? colours.text : colours.secondary;
    painter.setPen(QPen(colour, 1.0, m_markers.live ? Qt::SolidLine : Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(beamPixels());
    drawSymbol(painter, m_markers.live ? Symbol::Actual : Symbol::Lost, markerBox(*m_markers.actual, kActualSize),
               colour);
}

void SkyMarkers::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && m_projection.contains(event->position())) {
        Q_EMIT clicked(m_projection.toSky(event->position()));
    }
}

}  // namespace boresight::ui

#include "moc_sky_markers.cpp"
