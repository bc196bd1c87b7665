// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/symbol.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>

namespace boresight::ui {

namespace {

// Line width that suits a 12 px tag as well as a 32 px plot marker.
double strokeFor(const QRectF& box)
{
    return std::clamp(box.width() / 8.0, 1.5, 2.5);
}

void outline(QPainter& painter, const QPolygonF& shape, const QColor& colour, double width)
{
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(shape);
}

void fill(QPainter& painter, const QColor& colour)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
}

}  // namespace

void drawSymbol(QPainter& painter, Symbol symbol, const QRectF& box, const QColor& colour)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double stroke = strokeFor(box);
    const QRectF inner = box.adjusted(stroke, stroke, -stroke, -stroke);
    const QPointF c = box.center();
    switch (symbol) {
        case Symbol::None:
            break;
        case Symbol::Healthy:
            painter.setPen(QPen(colour, stroke));
            painter.drawEllipse(inner);
            break;
        case Symbol::Lost:
            painter.setPen(QPen(colour, stroke, Qt::DotLine));
            painter.drawEllipse(inner);
            break;
        case Symbol::Advisory:
        case Symbol::Actual:
            fill(painter, colour);
            painter.drawEllipse(inner);
            break;
        case Symbol::Warning:
            fill(painter, colour);
            painter.drawPolygon(QPolygonF({QPointF(c.x(), box.top()), box.bottomRight(), box.bottomLeft()}));
            break;
        case Symbol::Alarm:
            painter.fillRect(inner, colour);
            break;
        case Symbol::Target:
            outline(painter,
                    QPolygonF({QPointF(c.x(), inner.top()), QPointF(inner.right(), c.y()),
                               QPointF(c.x(), inner.bottom()), QPointF(inner.left(), c.y())}),
                    colour, stroke);
            break;
        case Symbol::Sensor:
            outline(painter, QPolygonF({QPointF(c.x(), inner.top()), inner.bottomRight(), inner.bottomLeft()}), colour,
                    stroke);
            break;
        case Symbol::Commanded:
            painter.setPen(QPen(colour, stroke, Qt::SolidLine, Qt::FlatCap));
            for (const QPointF& arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
                // Open in the middle, so that the three marks can be distinguished at the same place.
                painter.drawLine(c + arm * box.width() * 0.24, c + arm * box.width() * 0.5);
            }
            break;
    }
    painter.restore();
}

Symbol symbolOf(Severity severity)
{
    switch (severity) {
        case Severity::Warning:
            return Symbol::Warning;
        case Severity::Alarm:
            return Symbol::Alarm;
        case Severity::Advisory:
            break;
    }
    return Symbol::Advisory;
}

QString characterOf(Severity severity)
{
    switch (severity) {
        case Severity::Warning:
            return QStringLiteral("▲ ");
        case Severity::Alarm:
            return QStringLiteral("■ ");
        case Severity::Advisory:
            break;
    }
    return {};
}

Tone toneOf(Severity severity)
{
    switch (severity) {
        case Severity::Warning:
            return Tone::Warning;
        case Severity::Alarm:
            return Tone::Alarm;
        case Severity::Advisory:
            break;
    }
    return Tone::Advisory;
}

}  // namespace boresight::ui
