// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

class QPainter;
class QStyleOption;
class QWidget;

// How the parts of the screen are drawn in the colours of the current theme. The style uses it for Qt's own widgets,
// and a widget that paints itself uses it to look like them.
namespace boresight::ui {

// Four kinds of emphasis and no more: what the panel is for, everything else, what is rarely needed, and what is held
// or chosen (a state of each of them).
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
void paintBox(QPainter& painter, const QStyleOption& option, bool round);  // to tick, or of a choice

enum class Stroke
{
    Down,
    Plus,
    Minus
};
void paintStroke(QPainter& painter, Stroke stroke, const QRectF& box, bool enabled);

}  // namespace boresight::ui
