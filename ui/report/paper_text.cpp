// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/paper_text.h"

#include <QFontMetricsF>

#include <algorithm>

namespace boresight::ui {

QFont paperFont(int size, bool isBold)
{
    QFont font(QStringLiteral("sans-serif"));
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(size);
    font.setBold(isBold);
    return font;
}

QPen paperPen(const QColor& colour, qreal width, Qt::PenStyle style)
{
    return {colour, width, style, Qt::FlatCap, Qt::RoundJoin};
}

void drawPaperText(QPainter& painter, const QRectF& room, const PaperText& text)
{
    QFont font = paperFont(text.size, text.isBold);
    const int least = text.size * 2 / 3;
    const auto width = [&] { return QFontMetricsF(font, painter.device()).horizontalAdvance(text.text); };
    while (font.pixelSize() > least && width() > room.width()) {
        font.setPixelSize(font.pixelSize() - 1);
    }
    const QString shown = QFontMetricsF(font, painter.device()).elidedText(text.text, Qt::ElideRight, room.width());
    painter.setFont(font);
    painter.setPen(text.colour);
    painter.drawText(room, static_cast<int>(text.alignment) | Qt::TextSingleLine | Qt::TextDontClip, shown);
}

}  // namespace boresight::ui
