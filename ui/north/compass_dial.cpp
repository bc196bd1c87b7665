// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/compass_dial.h"

#include "ui/kit/format.h"
#include "ui/kit/symbol.h"
#include "ui/kit/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr double kTick = 5.0;      // px
constexpr double kLabelGap = 5.0;  // px between the rim and 90 or 270: a tick beside a number reads as a minus

QPointF onDial(QPointF middle, double radius, Angle angle)
{
    return middle + QPointF(radius * std::sin(angle.radians()), -radius * std::cos(angle.radians()));
}

void drawTriangle(QPainter& painter, QPointF at)
{
    painter.drawPolygon(QPolygonF{at + QPointF(0.0, -5.5), at + QPointF(5.0, 4.0), at + QPointF(-5.0, 4.0)});
}

}  // namespace

CompassDial::CompassDial(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Azimuth of the axis and heading of the sensor"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setToolTip(tr("● azimuth of the axis   △ heading of the sensor"));
}

void CompassDial::showNeedles(const std::optional<Angle>& axis, const std::optional<orientation::SensorHeading>& sensor)
{
    if (axis == m_axis && sensor == m_sensor) {
        return;
    }
    m_axis = axis;
    m_sensor = sensor;
    setAccessibleDescription(
        tr("axis %1, sensor %2")
            .arg(axis ? azimuthText(*axis, 1) : noValue(), sensor ? azimuthText(sensor->angle(), 1) : noValue()));
    update();
}

void CompassDial::paintEvent(QPaintEvent*)
{
    const Theme& colours = currentTheme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(fonts::label());
    const QFontMetricsF metrics(painter.font());
    const double aside = metrics.horizontalAdvance(QStringLiteral("270")) + 2.0 + kLabelGap;
    const double radius = std::min(width() - 2.0 * aside, height() - 2.0 * metrics.height()) / 2.0;
    const QPointF middle(QRectF(rect()).center().x(), radius + metrics.height());  // at the top, beside its words
    painter.setPen(colours.grid);
    painter.setBrush(colours.plotGround);
    painter.drawEllipse(middle, radius, radius);
    for (int degrees = 0; degrees < 360; degrees += 30) {
        const Angle angle = Angle::fromDegrees(degrees);
        painter.setPen(colours.secondary);
        painter.drawLine(onDial(middle, radius, angle), onDial(middle, radius - kTick, angle));
        if (degrees % 90 == 0) {
            const QString text = QString::number(degrees);
            const QSizeF size(metrics.horizontalAdvance(text) + 2.0, metrics.height());
            QRectF box(QPointF(), size);
            const double out = degrees % 180 == 0 ? size.height() / 2.0 : size.width() / 2.0 + kLabelGap;
            box.moveCenter(onDial(middle, radius + out, angle));
            painter.drawText(box, Qt::AlignCenter, text);
        }
    }
    if (m_sensor) {
        painter.setPen(QPen(colours.sensor, 1.5, Qt::DashLine));
        painter.setBrush(colours.plotGround);
        painter.drawLine(middle, onDial(middle, radius - 12.0, m_sensor->angle()));
        painter.setPen(QPen(colours.sensor, 1.5));
        drawTriangle(painter, onDial(middle, radius - 12.0, m_sensor->angle()));
    }
    if (m_axis) {
        painter.setPen(QPen(colours.text, 2.0));
        painter.drawLine(middle, onDial(middle, radius - 6.0, *m_axis));
        QRectF box(0.0, 0.0, 11.0, 11.0);
        box.moveCenter(onDial(middle, radius - 6.0, *m_axis));
        drawSymbol(painter, Symbol::Actual, box, colours.text);
    }
}

}  // namespace boresight::ui

#include "moc_compass_dial.cpp"
