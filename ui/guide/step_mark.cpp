// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/step_mark.h"

#include "ui/kit/symbol.h"

#include <QPainter>
#include <QPolygonF>

namespace boresight::ui {

void drawStepMark(QPainter& painter, StepState state, const QRectF& box, const QColor& colour)
{
    const auto at = [&box](double x, double y) {
        return QPointF(box.left() + x * box.width(), box.top() + y * box.height());
    };
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, box.width() / 6.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    switch (state) {
        case StepState::Done:
            painter.drawPolyline(QPolygonF({at(0.1, 0.55), at(0.4, 0.85), at(0.9, 0.15)}));
            break;
        case StepState::Skipped:
            for (const double x : {0.1, 0.5}) {
                painter.drawPolyline(QPolygonF({at(x, 0.15), at(x + 0.4, 0.5), at(x, 0.85)}));
            }
            break;
        case StepState::NeedsYou:
            drawSymbol(painter, Symbol::Warning, box, colour);
            break;
        case StepState::Open:
            drawSymbol(painter, Symbol::Healthy, box, colour);
            break;
    }
    painter.restore();
}

Tone toneOf(StepState state)
{
    return state == StepState::NeedsYou ? Tone::Warning : state == StepState::Open ? Tone::Normal : Tone::Secondary;
}

}  // namespace boresight::ui
