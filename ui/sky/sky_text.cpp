// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_text.h"

#include <QPainter>

namespace boresight::ui {

void drawOutlinedText(QPainter& painter, const QRectF& box, const QString& text, const QColor& colour,
                      const QColor& ground)
{
    constexpr int kFlags = Qt::AlignCenter | Qt::TextDontClip;
    painter.setPen(ground);
    for (const QPointF& offset : {QPointF(-1, -1), QPointF(0, -1), QPointF(1, -1), QPointF(-1, 0), QPointF(1, 0),
                                  QPointF(-1, 1), QPointF(0, 1), QPointF(1, 1), QPointF(-2, 0), QPointF(2, 0)}) {
        painter.drawText(box.translated(offset), kFlags, text);
    }
    painter.setPen(colour);
    painter.drawText(box, kFlags, text);
}

}  // namespace boresight::ui
