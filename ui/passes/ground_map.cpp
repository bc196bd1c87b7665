// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/ground_map.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/passes/coast_points.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr double kGridStep = 30.0;  // °
constexpr double kPassWidth = 2.5;  // px
constexpr double kMark = 4.0;
constexpr double kSiteMark = 6.0;

}  // namespace

GroundMap::GroundMap(QWidget* parent) : QWidget(parent)
{
    setFont(fonts::label());
    setAccessibleName(tr("Ground track of the satellite"));
    setToolTip(tr(
        "Thick line: the pass. Thin line: the orbit after it. Places inside the dashed circle see the satellite now."));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
}

void GroundMap::show(const GroundTrack& track)
{
    m_track = track;
    update();
}

void GroundMap::setSite(const std::optional<Site>& site)
{
    if (site != m_site) {
        m_site = site;
        update();
    }
}

void GroundMap::setPlace(const std::optional<Site>& below)
{
    m_place = below;
    setAccessibleDescription(below ? tr("Over latitude %1, longitude %2, %3 km high")
                                         .arg(angleText(below->latitude, 0), angleText(below->longitude, 0))
                                         .arg(below->heightMetres / 1000.0, 0, 'f', 0)
                                   : QString());
    update();
}

// The map is twice as wide as high, in the middle of the widget.
QRectF GroundMap::map() const
{
    const double across = std::min<double>(width(), 2.0 * height());
    return {(width() - across) / 2.0, (height() - across / 2.0) / 2.0, across, across / 2.0};
}

QPointF GroundMap::pixelOf(const Site& place) const
{
    const QRectF box = map();
    return {box.left() + box.width() * (place.longitude.wrapped180().degrees() + 180.0) / 360.0,
            box.top() + box.height() * (90.0 - place.latitude.degrees()) / 180.0};
}

QPainterPath GroundMap::lineOf(const std::vector<Site>& places) const
{
    QPainterPath path;
    for (const Site& place : places) {
        const QPointF at = pixelOf(place);
        if (path.elementCount() == 0 || std::abs(at.x() - path.currentPosition().x()) > map().width() / 2.0) {
            path.moveTo(at);
        } else {
            path.lineTo(at);
        }
    }
    return path;
}

void GroundMap::drawGround()
{
    m_ground = QPixmap(size() * devicePixelRatio());
    m_ground.setDevicePixelRatio(devicePixelRatio());
    const Theme& colours = currentTheme();
    m_ground.fill(colours.plotGround);
    QPainter painter(&m_ground);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto pixel = [&](double longitude, double latitude) {
        return pixelOf(
            {.latitude = Angle::fromDegrees(latitude), .longitude = Angle::fromDegrees(std::min(longitude, 179.99))});
    };
    QPainterPath land;
    QPolygonF coast;
    for (const CoastPoint& point : coastPoints()) {
        if (point == kCoastEnd) {
            land.addPolygon(coast);
            land.closeSubpath();
            coast.clear();
        } else {
            coast << pixel(point.longitude / 10.0, point.latitude / 10.0);
        }
    }
    painter.setPen(QPen(colours.secondary, 0.6));
    painter.setBrush(colours.land);
    painter.drawPath(land);
    painter.setPen(QPen(colours.grid, 0.6));
    painter.setBrush(Qt::NoBrush);
    for (double longitude = -180.0 + kGridStep; longitude < 180.0; longitude += kGridStep) {
        painter.drawLine(pixel(longitude, 90.0), pixel(longitude, -90.0));
    }
    for (double latitude = -90.0 + kGridStep; latitude < 90.0; latitude += kGridStep) {
        painter.drawLine(pixel(-180.0, latitude), pixel(180.0, latitude));
    }
    painter.drawRect(map().adjusted(0.5, 0.5, -0.5, -0.5));
}

void GroundMap::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_ground = {};
}

void GroundMap::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) {
        m_ground = {};
    }
    QWidget::changeEvent(event);
}

void GroundMap::paintEvent(QPaintEvent*)
{
    if (m_ground.isNull()) {
        drawGround();
    }
    const Theme& colours = currentTheme();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_ground);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours.accent, 1.0));
    painter.drawPath(lineOf(m_track.after));
    painter.setPen(QPen(colours.accent, kPassWidth));
    painter.drawPath(lineOf(m_track.pass));
    if (m_site) {
        const QPointF at = pixelOf(*m_site);
        painter.setPen(QPen(colours.text, 1.5));
        painter.drawLine(at - QPointF(kSiteMark, 0.0), at + QPointF(kSiteMark, 0.0));
        painter.drawLine(at - QPointF(0.0, kSiteMark), at + QPointF(0.0, kSiteMark));
    }
    if (m_place) {
        painter.setPen(QPen(colours.text, 1.2, Qt::DashLine));
        painter.drawPath(lineOf(footprintOf(*m_place)));
        painter.setPen(QPen(colours.plotGround, 1.0));
        painter.setBrush(colours.text);
        painter.drawEllipse(pixelOf(*m_place), kMark, kMark);
    }
}

}  // namespace boresight::ui

#include "moc_ground_map.cpp"
