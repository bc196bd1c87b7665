// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_markers.h"

#include "ui/kit/symbol.h"
#include "ui/sky/plot_bodies.h"
#include "ui/sky/sky_limits.h"
#include "ui/sky/sky_text.h"

#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
#include <iterator>
#include <utility>

namespace boresight::ui {

namespace {

constexpr double kActualSize = 13.0;  // px: fits inside the diamond and the cross when all are at one place
constexpr double kMarkerSize = 22.0;
constexpr double kCommandedSize = 32.0;
constexpr int kTextMargin = 3;
constexpr double kWayWidth = 2.0;
constexpr double kFocusWidth = 3.0;
constexpr float kBeamShade = 0.12F;

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

void SkyMarkers::setGround(const QPixmap& ground, const SkyProjection& projection, const std::optional<CableRing>& ring,
                           const std::vector<QRectF>& names)
{
    m_ground = ground;
    m_projection = projection;
    m_ring = ring;
    m_names = names;
    m_trail.setSky(projection);
    m_paths.setSky(projection);
    m_satellites.setSky(projection);
    rebuildWay();
    update();
}

void SkyMarkers::setMarkers(const MarkerData& markers, UtcTime utc)
{
    update(m_trail.age(utc));
    if (markers == m_markers) {
        return;
    }
    const QRegion before = occupied();
    m_markers = markers;
    if (m_markers.live && m_markers.actual) {
        update(m_trail.add(*m_markers.actual, utc));
    }
    rebuildWay();
    update(before + occupied());
}

void SkyMarkers::setCable(const CableState& cable)
{
    if (m_ring) {
        update(m_ring->changed(m_cable, cable));
    }
    m_cable = cable;
}

void SkyMarkers::setBodies(const std::vector<BodyPlace>& bodies)
{
    const auto region = [this] {
        QRegion boxes;
        for (const BodyPlace& body : m_bodies) {
            boxes += bodyBox(body, m_projection).toAlignedRect();
        }
        return boxes;
    };
    const auto places = [this] {
        std::vector<SkyPointing> directions;
        std::ranges::transform(m_bodies, std::back_inserter(directions), &BodyPlace::direction);
        return directions;
    };
    const auto before = std::pair(places(), region());
    m_bodies = bodiesInTheSky(m_bodies, bodies);
    if (places() != before.first) {
        update(before.second + region());
    }
}

void SkyMarkers::showPaths(const StationStatus& status)
{
    update(m_paths.show(status));
}

void SkyMarkers::setSatellites(const std::vector<SatellitePlace>& places)
{
    update(m_satellites.show(places));
}

void SkyMarkers::setTrail(const std::vector<SeenPlace>& places, UtcTime utc)
{
    update(m_trail.replace(places, utc));
}

void SkyMarkers::setPicked(const std::optional<SkyPointing>& direction)
{
    const QRegion before = occupied();
    m_markers.picked = direction;
    update(before + occupied());
}

void SkyMarkers::setFocused(bool on)
{
    m_focused = on;
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

QRectF SkyMarkers::markerBox(const SkyPointing& direction, double size) const
{
    const QPointF centre = m_projection.toPixel(direction);
    return {centre.x() - size / 2.0, centre.y() - size / 2.0, size, size};
}

double SkyMarkers::beamRadius() const
{
    return std::max(m_markers.beamWidth / 180_deg * m_projection.radius, kActualSize / 2.0 + 2.0);
}

// The beam around the actual direction. If only one angle is known: a line upwards, or a circle.
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
    // If no place hides nothing, the name of a keep-out may be hidden, and then the cable ring.
    struct Spared
    {
        bool ring;
        bool names;
    };
    for (const Spared& spared : {Spared{true, true}, Spared{true, false}, Spared{false, false}}) {
        for (const QPointF& offset : offsets) {
            const QPoint corner = (marker.center() + offset).toPoint();
            box.moveTopLeft({std::clamp(corner.x(), 0, most.x()), std::clamp(corner.y(), 0, most.y())});
            if (spared.ring) {
                box = m_projection.inside(QRectF(box)).toRect();
            }
            if (!covers(box) && !(spared.names && coversName(box))) {
                return box;
            }
        }
    }
    return box;
}

bool SkyMarkers::coversName(const QRect& box) const
{
    return std::ranges::any_of(m_names, [&box](const QRectF& name) { return name.intersects(box); });
}

// True if the box would hide the actual or the commanded direction.
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
    if (m_markers.offTarget && m_markers.actual && m_markers.expected) {
        region += around(m_projection.toPixel(*m_markers.actual), m_projection.toPixel(*m_markers.expected));
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
    if (m_focused) {
        painter.setPen(QPen(currentTheme().accent, kFocusWidth));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(m_projection.zenith, m_projection.radius, m_projection.radius);
    }
}

void SkyMarkers::paint(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    const Theme& colours = currentTheme();
    if (m_ring) {
        m_ring->paintCable(painter, m_cable);
    }
    for (const BodyPlace& body : m_bodies) {
        paintBody(painter, body, m_projection);
    }
    m_satellites.paint(painter);
    m_paths.paint(painter);
    m_trail.paint(painter);
    drawWay(painter);
    if (m_markers.picked) {
        painter.setPen(QPen(colours.accent, 1.5, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(markerBox(*m_markers.picked, kCommandedSize - 4.0));
    }
    if (m_markers.offTarget && m_markers.actual && m_markers.expected) {
        painter.setPen(QPen(colours.warning, 2.0));
        painter.drawLine(m_projection.toPixel(*m_markers.actual), m_projection.toPixel(*m_markers.expected));
    }
    drawActual(painter);
    if (m_markers.sensor) {
        drawSymbol(painter, Symbol::Sensor, markerBox(*m_markers.sensor, kMarkerSize), colours.sensor);
    }
    drawTarget(painter);
    if (m_markers.commanded) {
        drawSymbol(painter, Symbol::Commanded, markerBox(*m_markers.commanded, kCommandedSize), colours.text);
    }
    if (m_markers.actual) {
        drawSymbol(painter, m_markers.live ? Symbol::Actual : Symbol::Lost, markerBox(*m_markers.actual, kActualSize),
                   m_markers.live ? colours.text : colours.secondary);
    }
}

void SkyMarkers::drawWay(QPainter& painter) const
{
    QPen pen(currentTheme().accent, kWayWidth, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    pen.setDashPattern({4.0, 2.5});
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(
        m_wayPixels.toReversed());  // starting at the target, so that the dashes stand still while the way gets shorter
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
        drawOutlinedText(painter, box, m_markers.targetLabel, colours.accent, colours.skyRim);
    }
}

// The beam, below the markers.
void SkyMarkers::drawActual(QPainter& painter) const
{
    if (!m_markers.actual) {
        return;
    }
    const Theme& colours = currentTheme();
    QColor beam = colours.accent;
    beam.setAlphaF(kBeamShade);
    const bool filled = m_markers.live && !m_markers.missing;
    painter.setPen(
        QPen(m_markers.live ? colours.accent : colours.secondary, 1.2, m_markers.live ? Qt::SolidLine : Qt::DotLine));
    painter.setBrush(filled ? QBrush(beam) : QBrush(Qt::NoBrush));
    painter.drawPath(beamPixels());
}

void SkyMarkers::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && m_projection.contains(event->position())) {
        Q_EMIT clicked(m_projection.toSky(event->position()));
    }
}

}  // namespace boresight::ui

#include "moc_sky_markers.cpp"
