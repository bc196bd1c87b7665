// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/residual_sky.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/north/calibration_words.h"
#include "ui/sky/sky_projection.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr double kLongest = 24.0;         // px, of an arrow
constexpr double kLeast = 0.001;          // degrees: a shorter residual has no direction
constexpr double kResidualSkyHead = 4.0;  // px

}  // namespace

ResidualSky::ResidualSky(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Residuals on the sky"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ResidualSky::showPoints(const std::vector<PointStatus>& points)
{
    m_points = points;
    setAccessibleDescription(
        tr("%1 points. The largest residual is %2 now and %3 with the fit")
            .arg(points.size())
            .arg(angleText(Angle::fromDegrees(largest(false))), angleText(Angle::fromDegrees(largest(true)))));
    update();
}

void ResidualSky::setSelected(int row)
{
    if (row != m_selected) {
        m_selected = row;
        update();
    }
}

SkyProjection ResidualSky::sky() const
{
    const double line = QFontMetricsF(fonts::label()).height();
    const double height = this->height() - 3.0 * line;  // N above, S and the scales below
    const double radius = std::max(10.0, std::min(width() / 2.0 - line, height / 2.0 - line / 2.0));
    return {.zenith = QPointF(width() / 2.0, line + radius), .radius = radius};
}

double ResidualSky::largest(bool after) const
{
    double found = 0.0;
    for (const PointStatus& point : m_points) {
        if (point.isUsed && (!after || point.after)) {
            found = std::max(found, onSky(after ? *point.after : point.before));
        }
    }
    return found;
}

// Across is along the circle of equal elevation, clockwise. Elevation grows towards the zenith.
QPointF ResidualSky::tip(const PointStatus& point, bool after) const
{
    const PointResidual residual = after ? point.after.value_or(PointResidual{}) : point.before;
    const double scale = kLongest / std::max(largest(after), kLeast);
    const double azimuth = unflipped(point.truth).azimuth.radians();
    const QPointF clockwise(std::cos(azimuth), std::sin(azimuth));
    const QPointF inwards(-std::sin(azimuth), std::cos(azimuth));
    return sky().toPixel(point.truth) +
           scale * (residual.across.degrees() * clockwise + residual.elevation.degrees() * inwards);
}

void ResidualSky::paintGrid(QPainter& painter, const SkyProjection& projection) const
{
    const Theme& colours = currentTheme();
    painter.setPen(colours.grid);
    painter.setBrush(colours.plotGround);
    painter.drawEllipse(projection.zenith, projection.radius, projection.radius);
    painter.setBrush(Qt::NoBrush);
    for (const double ring : {1.0 / 3.0, 2.0 / 3.0}) {
        painter.drawEllipse(projection.zenith, ring * projection.radius, ring * projection.radius);
    }
    painter.setPen(colours.secondary);
    const double line = QFontMetricsF(painter.font()).height();
    const double reach = projection.radius + line / 2.0;
    const std::pair<QString, QPointF> letters[] = {
        {tr("N"), {0.0, -reach}}, {tr("E"), {reach, 0.0}}, {tr("S"), {0.0, reach}}, {tr("W"), {-reach, 0.0}}};
    for (const auto& [letter, offset] : letters) {
        QRectF box(0.0, 0.0, 2.0 * line, line);
        box.moveCenter(projection.zenith + offset);
        painter.drawText(box, Qt::AlignCenter, letter);
    }
}

void ResidualSky::paintArrow(QPainter& painter, const PointStatus& point, bool after) const
{
    const QPointF from = sky().toPixel(point.truth);
    const QPointF to = tip(point, after);
    const double length = std::hypot(to.x() - from.x(), to.y() - from.y());
    if (length < 1.0) {
        return;
    }
    painter.setPen(after ? QPen(currentTheme().accent, 2.0) : QPen(currentTheme().secondary, 1.2, Qt::DashLine));
    painter.drawLine(from, to);
    const QPointF along = (to - from) / length;
    const QPointF beside(-along.y(), along.x());
    painter.setPen(QPen(after ? currentTheme().accent : currentTheme().secondary, 1.2));
    painter.drawLine(to, to - kResidualSkyHead * along + kResidualSkyHead / 2.0 * beside);
    painter.drawLine(to, to - kResidualSkyHead * along - kResidualSkyHead / 2.0 * beside);
}

void ResidualSky::paintEvent(QPaintEvent*)
{
    const Theme& colours = currentTheme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(fonts::label());
    paintGrid(painter, sky());
    for (std::size_t row = 0; row < m_points.size(); ++row) {
        const PointStatus& point = m_points[row];
        const bool selected = static_cast<int>(row) == m_selected;
        const QPointF at = sky().toPixel(point.truth);
        if (point.isUsed) {
            paintArrow(painter, point, false);
            paintArrow(painter, point, true);
        }
        painter.setPen(QPen(selected ? colours.accent : colours.text, selected ? 2.0 : 1.0));
        painter.setBrush(point.isUsed ? QBrush(colours.text) : QBrush(Qt::NoBrush));
        painter.drawEllipse(at, selected ? 4.5 : 3.0, selected ? 4.5 : 3.0);
    }
    painter.setPen(colours.secondary);
    const double line = QFontMetricsF(painter.font()).height();
    const QRectF below(0.0, height() - line - 2.0, width(), line + 2.0);
    painter.drawText(
        below, Qt::AlignCenter,
        tr("longest: ┄ %1  — %2")
            .arg(angleText(Angle::fromDegrees(largest(false))), angleText(Angle::fromDegrees(largest(true)), 3)));
}

}  // namespace boresight::ui

#include "moc_residual_sky.cpp"
