// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/polar_plot.h"

#include "core/pointing/missing_axis.h"
#include "core/pointing/sun_keep_out.h"
#include "core/units/angle_between.h"
#include "ui/kit/axes.h"
#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/sky/plot_tools.h"
#include "ui/sky/sky_items.h"

#include <QContextMenuEvent>
#include <QEvent>
#include <QPainter>
#include <QRadialGradient>
#include <QWheelEvent>
#include <qwt_point_polar.h>
#include <qwt_polar_grid.h>
#include <qwt_polar_plot.h>
#include <qwt_scale_div.h>
#include <qwt_scale_map.h>

#include <algorithm>
#include <numbers>
#include <utility>

namespace boresight::ui {

namespace {

constexpr int kWheelStep = 120;  // one notch of a mouse wheel, in eighths of a degree

// The expected direction of the mount. On the way to a fixed target, and while it waits, this is the set-point: the
// rest of the way is planned.
std::optional<SkyPointing> expectedPlace(const StationStatus& status)
{
    const bool isPlanned = status.slew || !status.route.empty() || status.state == StationState::Hold;
    return isPlanned ? status.commanded : status.target;
}

std::optional<Angle> distanceTo(const StationStatus& status, const std::optional<SkyPointing>& place)
{
    if (!status.actual || !place) {
        return std::nullopt;
    }
    const SkyPointing actual = unflipped(*status.actual);
    const SkyPointing there = unflipped(*place);
    const auto missing = missingAxis(status);
    return missing ? pointing::leastAngleBetween(actual, there, *missing) : angleBetween(actual, there);
}

// The forbidden areas and the travel of the axes. On a mount with one axis a limit of this axis applies to all values
// of the missing angle, and is drawn for all of them.
std::pair<pointing::Region, Travel> groundOf(const StationStatus& status)
{
    pointing::Region region = pointing::withSun(status.profile->limits, status.sunKeepOuts);
    const pointing::PointingTerms terms = termsOf(status);
    Travel travel{status.azimuth.travel, status.elevation.travel, pointing::PointingModel(terms)};
    if (const auto missing = missingAxis(status)) {
        region = pointing::withoutAxis(region, *missing);
        travel.pointing = pointing::PointingModel(pointing::withoutAxis(terms, *missing));
        (*missing == Axis::Azimuth ? travel.azimuth : travel.elevation) =
            *missing == Axis::Azimuth ? TravelRange{0_deg, 360_deg} : TravelRange{0_deg, 90_deg};
        for (pointing::KeepOut& keepOut : region.keepOuts) {
            keepOut.elevationMin = std::max(keepOut.elevationMin, 0_deg);  // its name is drawn in the middle
        }
    }
    return {region, travel};
}

Freshness worseFreshness(const StationStatus& status)
{
    return std::max(freshness(status.azimuth.age), freshness(status.elevation.age));
}

// The direction as text, without the angle of the missing axis.
QString knownText(const SkyPointing& direction, std::optional<Axis> missing)
{
    if (!missing) {
        return directionText(direction);
    }
    return *missing == Axis::Azimuth ? shortName(Axis::Elevation) + QLatin1Char(' ') + angleText(direction.elevation, 1)
                                     : shortName(Axis::Azimuth) + QLatin1Char(' ') + azimuthText(direction.azimuth, 1);
}

QString targetLabel(const StationStatus& status)
{
    if (!status.target) {
        return {};
    }
    QString text = knownText(*status.target, missingAxis(status));
    text = status.target->elevation > 90_deg ? PolarPlot::tr("FLIP %1").arg(text) : text;
    return status.slew ? PolarPlot::tr("%1, in %2").arg(text, waitText(status.slew->remaining)) : text;
}

QString placeText(const QString& what, const std::optional<SkyPointing>& place, std::optional<Axis> missing = {})
{
    return place ? what + QLatin1Char(' ') + knownText(*place, missing) + QStringLiteral(". ") : QString();
}

QwtScaleDiv scaleDiv(double from, double to, const std::vector<double>& lines)
{
    return QwtScaleDiv(from, to, {}, {}, QList<double>(lines.begin(), lines.end()));
}

}  // namespace

PolarPlot::PolarPlot(ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_grid(std::make_unique<QwtPolarGrid>()),
      m_regionItem(std::make_unique<RegionItem>()),
      m_labels(std::make_unique<LabelsItem>()),
      m_plot(new QwtPolarPlot(this)),
      m_markers(new SkyMarkers(this)),
      m_editor(new PlotEditor(draft, this)),
      m_tools(new PlotTools(this)),
      m_menu(new PlotMenu(draft, desk, this))
{
    setAccessibleName(tr("Sky plot"));
    setToolTipDuration(5000);
    m_markers->setToolTip(
        tr("North is up, east is right, the zenith is in the centre. A click reads a direction. A right click shows "
           "the commands for a direction."));
    setFocusPolicy(Qt::TabFocus);
    m_plot->setAutoDelete(false);  // the plot owns these items itself
    m_plot->setFrameStyle(QFrame::NoFrame);
    m_plot->hide();  // only used for drawing: SkyMarkers shows the result
    setUpScales();
    m_regionItem->setZ(1.0);
    m_grid->setZ(2.0);
    m_labels->setZ(3.0);
    m_regionItem->attach(m_plot);
    m_grid->attach(m_plot);
    m_labels->attach(m_plot);
    setColours();
    setUpTools();
    setUpMenu();
    connect(m_markers, &SkyMarkers::clicked, this, &PolarPlot::clicked);
}

PolarPlot::~PolarPlot() = default;

void PolarPlot::setUpScales()
{
    m_plot->setAzimuthOrigin(std::numbers::pi / 2.0);
    m_grid->setGridAttribute(QwtPolarGrid::AutoScaling, false);  // otherwise Qwt chooses its own rings
    m_grid->setRenderHint(QwtPolarItem::RenderAntialiased);
    for (int axis = 0; axis < QwtPolar::AxesCount; ++axis) {
        m_grid->showAxis(axis, false);  // LabelsItem draws the labels: Qwt would label north 360
    }
    for (const int scale : {QwtPolar::Azimuth, QwtPolar::Radius}) {
        m_grid->showGrid(scale, true);
        m_grid->showMinorGrid(scale, false);
    }
    setGrid(wholeSkyGrid());
}

void PolarPlot::setUpTools()
{
    m_tools->setPainter([this](QPainter& painter) { paintPicture(painter); });
    connect(m_tools, &PlotTools::editToggled, this, &PolarPlot::setEditing);
    connect(m_tools, &PlotTools::zoomToggled, this, &PolarPlot::toggleZoom);
    connect(m_editor, &PlotEditor::leaveWanted, this, [this] { setEditing(false); });
    connect(m_editor, &PlotEditor::readout, m_tools, &PlotTools::setReadout);
    connect(m_tools, &PlotTools::readoutToggled, this, &PolarPlot::drawGround);
}

void PolarPlot::setUpMenu()
{
    connect(m_menu, &PlotMenu::goHereWanted, this, &PolarPlot::goHereWanted);
    connect(m_menu, &PlotMenu::horizonPointWanted, this, [this](const SkyPointing& at) {
        setEditing(true);
        m_editor->addPoint(at);
    });
    connect(m_menu, &PlotMenu::keepOutWanted, this, [this](const SkyPointing& at) {
        setEditing(true);
        m_editor->addSector(at);
    });
}

void PolarPlot::setGrid(const SkyGrid& grid)
{
    m_labels->setGrid(grid);
    m_plot->setScaleDiv(QwtPolar::Azimuth, scaleDiv(360.0, 0.0, grid.azimuths));
    m_plot->setScaleDiv(QwtPolar::Radius, scaleDiv(90.0, 0.0, grid.elevations));
}

void PolarPlot::setColours()
{
    m_grid->setMajorGridPen(QPen(currentTheme().grid, 1.0));
    m_plot->setPlotBackground(Qt::NoBrush);  // paintSky() draws it
}

// Qwt puts the circle at the top of its area. This is the largest square in the middle.
QRectF PolarPlot::square() const
{
    const double side = std::min(width(), height());
    return {(width() - side) / 2.0, (height() - side) / 2.0, side, side};
}

// The area that Qwt draws into: the square, or a larger one whose magnified part fills the widget.
QRectF PolarPlot::canvas() const
{
    if (!m_zoom.isOn()) {
        return square();
    }
    const SkyProjection zoomed = sky();
    const double half = zoomed.radius + m_labels->marginHint();
    return {zoomed.zenith.x() - half, zoomed.zenith.y() - half, 2.0 * half, 2.0 * half};
}

SkyProjection PolarPlot::wholeSky() const
{
    const QRectF circle = m_plot->plotRect(square());
    return {circle.center(), circle.width() / 2.0};
}

SkyProjection PolarPlot::sky() const
{
    return m_zoom.projection(wholeSky());
}

// There is no ring for a mount without an azimuth cable, or for a magnified part of the sky.
std::optional<CableRing> PolarPlot::ring() const
{
    const bool there = !m_zoom.isOn() && m_cableTravel.min < m_cableTravel.max;
    return there ? std::optional(CableRing(m_frame, m_cableTravel, m_cableZero)) : std::nullopt;
}

void PolarPlot::changeView()
{
    m_labels->setView(rect(), m_zoom.isOn());
    m_frame = SkyFrame(rect(), wholeSky());
    m_tools->setFrame(m_frame);
    const SkyGrid grid = m_zoom.isOn() ? gridOf(sky(), rect()) : wholeSkyGrid();
    setGrid(grid);
    m_regionItem->setView(rect());
    m_tools->showZoom(m_zoom.isOn());
    drawGround();
}

// Shading from the rim to the zenith, stronger at the rim. Where the mount mostly works the sky is plain.
void PolarPlot::paintSky(QPainter& painter) const
{
    const SkyProjection shown = sky();
    const Theme& colours = currentTheme();
    QRadialGradient tone(shown.zenith, shown.radius);
    tone.setColorAt(0.0, colours.skyZenith);
    tone.setColorAt(1.0, colours.skyRim);
    painter.setPen(Qt::NoPen);
    painter.setBrush(tone);
    painter.drawEllipse(shown.zenith, shown.radius, shown.radius);
    painter.setBrush(Qt::NoBrush);  // Qwt draws the rings of its grid with the present brush
}

void PolarPlot::paintGround(QPainter& painter) const
{
    painter.fillRect(rect(), currentTheme().window);
    painter.setRenderHint(QPainter::Antialiasing);
    paintSky(painter);
    m_plot->drawCanvas(&painter, canvas());
    painter.setRenderHint(QPainter::Antialiasing);
    const SkyProjection shown = sky();
    painter.setPen(QPen(currentTheme().secondary, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(shown.zenith, shown.radius, shown.radius);
    if (m_zoom.isOn()) {
        const double corner = std::max<double>(m_tools->readoutHeight(), legendHeight(m_frame, m_legend));
        drawZoomMark(painter, rect(), corner, shown, m_zoom.magnification());
    } else {
        m_frame.paint(painter);
    }
    if (const auto cable = ring()) {
        cable->paintTrack(painter, m_wrapKnown);
    }
    if (!m_tools->hasReadout()) {
        paintLegend(painter, rect(), m_frame, m_legend);
    }
}

void PolarPlot::drawGround()
{
    if (width() < 2 || height() < 2) {
        return;
    }
    QPixmap ground(size() * devicePixelRatio());
    ground.setDevicePixelRatio(devicePixelRatio());
    QPainter painter(&ground);
    paintGround(painter);
    m_markers->setGround(ground, sky(), ring(), m_regionItem->nameBoxes(sky()));
    m_editor->setSky(sky());
}

void PolarPlot::paintPicture(QPainter& painter) const
{
    painter.setClipRect(rect());
    paintGround(painter);
    m_markers->paint(painter);
    m_tools->paintWords(painter);
    painter.setFont(fonts::label());
    painter.setPen(currentTheme().text);
    painter.drawText(rect().adjusted(6, 4, -4, -4), Qt::AlignLeft | Qt::AlignTop, m_caption);
}

void PolarPlot::resizeEvent(QResizeEvent*)
{
    m_plot->resize(size());
    for (QWidget* const layer : std::initializer_list<QWidget*>{m_markers, m_editor, m_tools}) {
        layer->resize(size());
    }
    changeView();
}

// A right click means the place under the mouse. The menu key means the picked place, otherwise the target.
void PolarPlot::contextMenuEvent(QContextMenuEvent* event)
{
    const SkyProjection shown = sky();
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const SkyPointing there =
        byKey ? unflipped(m_markers->markers().picked.value_or(m_focus)) : shown.toSky(event->pos());
    if (byKey || shown.contains(event->pos())) {
        m_menu->open(there, byKey ? mapToGlobal(shown.toPixel(there).toPoint()) : event->globalPos());
    }
}

void PolarPlot::wheelEvent(QWheelEvent* event)
{
    m_wheel += event->angleDelta().y();
    const int steps = m_wheel / kWheelStep;
    m_wheel -= steps * kWheelStep;
    if (steps != 0) {
        zoomBy(steps);
    }
    event->accept();
}

void PolarPlot::toggleZoom()
{
    m_zoom.centreOn(m_focus);
    m_zoom.toggle(m_beamWidth);
    changeView();
}

void PolarPlot::zoomBy(int steps)
{
    if (!m_zoom.isOn()) {
        m_zoom.centreOn(m_focus);
    }
    m_zoom.step(steps, m_beamWidth);
    changeView();
}

void PolarPlot::setEditing(bool on)
{
    if (on != m_editor->isEditing()) {
        m_editor->setEditing(on);
        m_tools->showEditing(on);
        Q_EMIT editingChanged(on);
    }
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
    showRegion(status);
    showCable(status);
    showMarkers(status);
    m_menu->showStatus(status);
}

// The track is a part of the ground. The moving parts are not.
void PolarPlot::showCable(const StationStatus& status)
{
    const CableState cable = cableOf(status);
    if (cable.travel != m_cableTravel || cable.zero != m_cableZero || cable.wrapKnown != m_wrapKnown) {
        m_cableTravel = cable.travel;
        m_cableZero = cable.zero;
        m_wrapKnown = cable.wrapKnown;
        drawGround();
    }
    m_markers->setCable(cable);
    m_tools->showCable(cableWords(status));
}

void PolarPlot::showRegion(const StationStatus& status)
{
    const auto [region, travel] = groundOf(status);
    m_beamWidth = antennaOf(status).beamWidth;
    m_focus = status.target ? *status.target : status.actual.value_or(m_focus);
    const bool moved = !m_editor->isDragging() && m_zoom.follow(m_focus);
    const bool changed = m_region != region || travel != m_travel;
    if (changed) {
        m_region = region;
        m_travel = travel;
        m_regionItem->setRegion(*m_region, travel);
        m_editor->setTravel(travel);
    }
    if (changed || moved) {
        changeView();
    }
}

void PolarPlot::showMarkers(const StationStatus& status)
{
    const Freshness age = worseFreshness(status);
    MarkerData markers = m_markers->markers();
    markers.actual = status.actual;
    const bool known = areTurnsKnown(status);
    markers.commanded = age == Freshness::NoData || !known ? std::nullopt : status.commanded;
    markers.target = status.target;
    markers.sensor = status.sensor.direction;
    markers.way = markers.commanded ? status.route : std::vector<SkyPointing>();
    markers.expected = expectedPlace(status);
    markers.missing = missingAxis(status);
    markers.targetLabel = targetLabel(status);
    markers.beamWidth = m_beamWidth;
    markers.live = age == Freshness::Live && known;
    // The error exceeds half a beam width on the sky.
    markers.offTarget = markers.live && distanceTo(status, markers.expected).value_or(0_deg) > 0.5 * m_beamWidth;
    m_markers->setMarkers(markers, status.utc);
    m_markers->setBodies(status.bodies);
    m_markers->showPaths(status);
    showLegend({.hasSensor = markers.sensor.has_value(), .hasBeam = m_markers->paths().hasBeam()});
    m_tools->showOffTarget(markers.live ? distanceTo(status, status.target) : std::nullopt, m_beamWidth,
                           markers.offTarget);
    m_tools->showBudget(markers.live ? status.errorBudget : std::nullopt, status.utc);
    m_caption = QString::fromStdString(status.profile->mount.name) + QStringLiteral("  ") + minuteText(status.utc);
}

void PolarPlot::showLegend(const LegendParts& parts)
{
    if (parts != m_legend) {
        m_legend = parts;
        drawGround();
    }
}

void PolarPlot::setPicked(const std::optional<SkyPointing>& direction)
{
    m_markers->setPicked(direction);
}

void PolarPlot::setSatellites(const std::vector<SatellitePlace>& places)
{
    m_markers->setSatellites(places);
}

void PolarPlot::describe(const StationStatus& status)
{
    const bool live = worseFreshness(status) == Freshness::Live;
    const QString actual = !live ? tr("Last seen at") : areTurnsKnown(status) ? tr("Actual") : tr("Perhaps at");
    const auto missing = missingAxis(status);
    setAccessibleDescription((placeText(actual, status.actual, missing) +
                              placeText(tr("Commanded"), status.commanded, missing) +
                              placeText(tr("Target"), status.target, missing) +
                              placeText(tr("Sensor"), status.sensor.direction) + cableWords(status).sentence)
                                 .trimmed());
}

QPointF PolarPlot::qwtPixel(const SkyPointing& direction) const
{
    const QRectF circle = m_plot->plotRect(canvas());
    const double radius = circle.width() / 2.0;
    return qwtPolar2Pos(circle.center(),
                        m_plot->scaleMap(QwtPolar::Radius, radius).transform(direction.elevation.degrees()),
                        m_plot->scaleMap(QwtPolar::Azimuth, radius).transform(direction.azimuth.degrees()));
}

}  // namespace boresight::ui

#include "moc_polar_plot.cpp"
