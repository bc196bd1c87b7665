// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QRectF>
#include <QString>

class QPainter;

namespace boresight::ui {

// A text that is readable on lines and hatching: its letters have an outline in the colour of the ground.
void drawOutlinedText(QPainter& painter, const QRectF& box, const QString& text, const QColor& colour,
                      const QColor& ground);

}  // namespace boresight::ui
