// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/polar_plot.h"

#include "ui/axes.h"
#include "ui/format.h"
#include "ui/sky_items.h"
#include "ui/theme.h"

#include <QEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <qwt_point_polar.h>
#include <qwt_polar_grid.h>
#include <qwt_polar_plot.h>
#include <qwt_scale_map.h>

#include <cmath>
#include <numbers>

namespace boresight::ui {

namespace {

// Off target means that the beam no longer covers the target: half a beam width on the sky.
bool isOffTarget(const StationStatus& status, Angle beamWidth)
{
    if (!status.actual || !status.target) {
        return false;
    }
    const SkyPointing a = unflipped(*status.actual);
    const SkyPointing b = unflipped(*status.target);
    const double cosine =
        std::sin(a.elevation.radians()) * std::sin(b.elevation.radians()) +
        std::cos(a.elevation.radians()) * std::cos(b.elevation.radians()) * std::cos((a.azimuth - b.azimuth).radians());
    return Angle::fromRadians(std::acos(std::clamp(cosine, -1.0, 1.0))) > 0.5 * beamWidth;
}

Freshness worseFreshness(const StationStatus& status)
{
    return std::max(freshness(status.azimuth.age), freshness(status.elevation.age));
}

QString targetLabel(const StationStatus& status)
{
    if (!status.target) {
        return {};
    }
    const QString text = directionText(*status.target);
    return status.target->elevation > 90_deg ? PolarPlot::tr("FLIP %1").arg(text) : text;
}

QString placeText(const QString& what, const std::optional<SkyPointing>& place)
{
    return place ? what + QLatin1Char(' ') + directionText(*place) + QStringLiteral(". ") : QString();
}

}  // namespace

PolarPlot::PolarPlot(Angle beamWidth, QWidget* parent)
    : QWidget(parent),
      m_grid(std::make_unique<QwtPolarGrid>()),
      m_sectors(std::make_unique<SectorsItem>()),
      m_labels(std::make_unique<LabelsItem>()),
      m_plot(new QwtPolarPlot(this)),
      m_markers(new SkyMarkers(this)),
      m_beamWidth(beamWidth)
{
    setAccessibleName(tr("Sky plot"));
    setToolTipDuration(5000);
    m_markers->setToolTip(tr("North is up, east is right, the zenith in the centre. A click reads a direction."));
    m_plot->setAutoDelete(false);  // the items are ours
    m_plot->setFrameStyle(QFrame::NoFrame);
    m_plot->hide();  // a draughtsman only: SkyMarkers shows what it draws
    setUpScales();
    m_sectors->setZ(1.0);
    m_grid->setZ(2.0);
    m_labels->setZ(3.0);
    m_sectors->attach(m_plot);
    m_grid->attach(m_plot);
    m_labels->attach(m_plot);
    setColours();
    connect(m_markers, &SkyMarkers::clicked, this, &PolarPlot::clicked);
}

PolarPlot::~PolarPlot() = default;

void PolarPlot::setUpScales()
{
    m_plot->setAzimuthOrigin(std::numbers::pi / 2.0);
    m_plot->setScaleMaxMinor(QwtPolar::Azimuth, 1);
    m_plot->setScaleMaxMinor(QwtPolar::Radius, 1);  // before the scales: it discards them
    m_plot->setScale(QwtPolar::Azimuth, 360.0, 0.0, 30.0);
    m_plot->setScale(QwtPolar::Radius, 90.0, 0.0, 30.0);
    m_grid->setGridAttribute(QwtPolarGrid::AutoScaling, false);  // else it chooses its own rings
    m_grid->setRenderHint(QwtPolarItem::RenderAntialiased);
    for (int axis = 0; axis < QwtPolar::AxesCount; ++axis) {
        m_grid->showAxis(axis, false);  // LabelsItem: Qwt would label north 360
    }
    for (const int scale : {QwtPolar::Azimuth, QwtPolar::Radius}) {
        m_grid->showGrid(scale, true);
        m_grid->showMinorGrid(scale, false);
    }
}

void PolarPlot::setColours()
{
    m_grid->setMajorGridPen(QPen(currentTheme().grid, 1.0));
    m_plot->setPlotBackground(currentTheme().plotGround);
}

// Qwt puts the circle at the top of what it is given; this is the largest square in the middle.
QRectF PolarPlot::square() const
{
    const double side = std::min(width(), height());
    return {(width() - side) / 2.0, (height() - side) / 2.0, side, side};
}

void PolarPlot::drawGround()
{
    if (width() < 2 || height() < 2) {
        return;
    }
    QPixmap ground(size() * devicePixelRatio());
    ground.setDevicePixelRatio(devicePixelRatio());
    ground.fill(currentTheme().window);
    QPainter painter(&ground);
    m_plot->drawCanvas(&painter, square());
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF circle = m_plot->plotRect(square());
    painter.setPen(QPen(currentTheme().secondary, 1.0));
    painter.drawEllipse(circle);
    drawLegend(painter, QPointF(2.0, 2.0));
    m_markers->setGround(ground, SkyProjection{circle.center(), circle.width() / 2.0});
}

void PolarPlot::resizeEvent(QResizeEvent*)
{
    m_plot->resize(size());
    m_markers->resize(size());
    drawGround();
}

void PolarPlot::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) {
        setColours();
        drawGround();
    }
    QWidget::changeEvent(event);
}

void PolarPlot::showStatus(const StationStatus& status)
{
    if (status.azimuth.travel != m_azimuthTravel || status.elevation.travel != m_elevationTravel) {
        m_azimuthTravel = status.azimuth.travel;
        m_elevationTravel = status.elevation.travel;
        m_sectors->setSectors(unreachable(m_azimuthTravel, m_elevationTravel));
        drawGround();
    }
    const Freshness age = worseFreshness(status);
    MarkerData markers = m_markers->markers();
    markers.actual = status.actual;
    const bool known = areTurnsKnown(status);
    markers.commanded = age == Freshness::NoData || !known ? std::nullopt : status.commanded;
    markers.target = status.target;
    markers.targetLabel = targetLabel(status);
    markers.beamWidth = m_beamWidth;
    markers.live = age == Freshness::Live && known;
    markers.offTarget = markers.live && isOffTarget(status, m_beamWidth);
    m_markers->setMarkers(markers);
}

void PolarPlot::setPicked(const std::optional<SkyPointing>& direction)
{
    MarkerData markers = m_markers->markers();
    markers.picked = direction;
    m_markers->setMarkers(markers);
}

void PolarPlot::describe(const StationStatus& status)
{
    const bool live = worseFreshness(status) == Freshness::Live;
    const QString actual = !live ? tr("Last seen at") : areTurnsKnown(status) ? tr("Actual") : tr("Perhaps at");
    setAccessibleDescription((placeText(actual, status.actual) + placeText(tr("Commanded"), status.commanded) +
                              placeText(tr("Target"), status.target))
                                 .trimmed());
}

QPointF PolarPlot::qwtPixel(const SkyPointing& direction) const
{
    const QRectF circle = m_plot->plotRect(square());
    const double radius = circle.width() / 2.0;
    return qwtPolar2Pos(circle.center(),
                        m_plot->scaleMap(QwtPolar::Radius, radius).transform(direction.elevation.degrees()),
                        m_plot->scaleMap(QwtPolar::Azimuth, radius).transform(direction.azimuth.degrees()));
}

}  // namespace boresight::ui
