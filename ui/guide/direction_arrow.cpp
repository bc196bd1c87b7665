// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/direction_arrow.h"

#include "ui/kit/axes.h"
#include "ui/kit/theme.h"

#include <QPainter>
#include <QPainterPath>

#include <cmath>
#include <numbers>

namespace boresight::ui {

namespace {

constexpr double kHead = 9.0;  // px, length of the arrow's head

// `degrees`: counter-clockwise from the right, like the angles of Qt's arcs.
QPointF onCircle(QPointF centre, double radius, double degrees)
{
    const double radians = degrees * std::numbers::pi / 180.0;
    return centre + QPointF(radius * std::cos(radians), -radius * std::sin(radians));
}

void drawArc(QPainter& painter, QPointF centre, double radius, double from, double to)
{
    QPainterPath path;
    const QRectF box(centre - QPointF(radius, radius), centre + QPointF(radius, radius));
    path.arcMoveTo(box, from);
    path.arcTo(box, from, to - from);
    painter.drawPath(path);
    // The head lies along the circle, so that its tip is at the end.
    const double back = to - std::copysign(kHead / radius * 180.0 / std::numbers::pi, to - from);
    QPainterPath head(onCircle(centre, radius, to));
    head.lineTo(onCircle(centre, radius + 0.5 * kHead, back));
    head.lineTo(onCircle(centre, radius - 0.5 * kHead, back));
    head.closeSubpath();
    painter.fillPath(head, painter.pen().color());
}

}  // namespace

DirectionArrow::DirectionArrow(Axis axis, QWidget* parent) : QWidget(parent), m_axis(axis)
{
    setAccessibleName(tr("Direction of the %1").arg(name(axis)));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    describe();
}

void DirectionArrow::setTurning(Turning turning)
{
    if (turning != m_turning) {
        m_turning = turning;
        describe();
        update();
    }
}

void DirectionArrow::describe()
{
    const bool azimuth = m_axis == Axis::Azimuth;
    setAccessibleDescription(m_turning == Turning::Rests ? tr("standing still")
                             : m_turning == Turning::Grows
                                 ? (azimuth ? tr("clockwise, seen from above") : tr("upwards"))
                             : azimuth ? tr("counter-clockwise, seen from above")
                                       : tr("downwards"));
    setToolTip(azimuth ? tr("Seen from above: a growing azimuth turns clockwise, from north to east")
                       : tr("Seen from the side: a growing elevation raises the antenna"));
}

QSize DirectionArrow::sizeHint() const
{
    return {72, 72};
}

void DirectionArrow::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& theme = currentTheme();
    const bool moves = m_turning != Turning::Rests;
    const bool shrinks = m_turning == Turning::Shrinks;
    painter.setPen(QPen(theme.grid, 1.5));
    const QPen arrow(moves ? theme.accent : theme.secondary, moves ? 4.0 : 2.0);
    if (m_axis == Axis::Azimuth) {
        const QPointF centre(width() / 2.0, height() / 2.0);
        painter.drawEllipse(centre, 17.0, 17.0);
        painter.drawLine(centre, centre - QPointF(0.0, 17.0));  // the beam
        painter.setPen(arrow);
        drawArc(painter, centre, 29.0, shrinks ? 30.0 : 150.0, shrinks ? 150.0 : 30.0);
    } else {
        const QPointF foot(14.0, height() - 14.0);
        painter.drawLine(foot, foot + QPointF(50.0, 0.0));  // the horizon
        painter.drawLine(foot, onCircle(foot, 36.0, 30.0));
        painter.setPen(arrow);
        drawArc(painter, foot, 46.0, shrinks ? 65.0 : 8.0, shrinks ? 8.0 : 65.0);
    }
}

}  // namespace boresight::ui

#include "moc_direction_arrow.cpp"
