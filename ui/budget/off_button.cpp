// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/budget/off_button.h"

#include "ui/kit/theme.h"

#include <QPainter>

namespace boresight::ui {

namespace {

constexpr double kOffCorner = 6.0;  // px

}  // namespace

OffButton::OffButton(QWidget* parent) : QToolButton(parent)
{
    setText(tr("Error budget"));
    setAccessibleName(tr("Show the error budget"));
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
}

void OffButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& colours = currentTheme();
    const bool isMarked = hasFocus() || isDown() || underMouse();
    const double width = hasFocus() ? 2.0 : 1.0;
    painter.setPen(QPen(isMarked ? colours.accent : colours.grid, width));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(width / 2, width / 2, -width / 2, -width / 2), kOffCorner,
                            kOffCorner);
}

}  // namespace boresight::ui

#include "moc_off_button.cpp"
