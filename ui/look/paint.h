// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

class QPainter;
class QStyleOption;
class QWidget;

// Draws the parts of the screen in the colours of the current theme. The style uses it for Qt's own widgets, and
// widgets that paint themselves use it to look the same.
namespace boresight::ui {

// Only these kinds of emphasis: the main action of a panel, everything else, rarely used actions, and the pressed or
// chosen state of each.
enum class Emphasis
{
    Normal,
    Primary,
    Quiet
};

void setEmphasis(QWidget& button, Emphasis emphasis);
[[nodiscard]] Emphasis emphasisOf(const QWidget* button);

void paintCard(QPainter& painter, const QRectF& box);
void paintFocus(QPainter& painter, const QRectF& box);
void paintButton(QPainter& painter, const QStyleOption& option, Emphasis emphasis);
void paintField(QPainter& painter, const QStyleOption& option);  // of words and numbers
void paintTab(QPainter& painter, const QStyleOption& option);
void paintBox(QPainter& painter, const QStyleOption& option, bool round);  // a check box or a radio button

enum class Stroke
{
    Down,
    Plus,
    Minus
};
void paintStroke(QPainter& painter, Stroke stroke, const QRectF& box, bool enabled);

}  // namespace boresight::ui
