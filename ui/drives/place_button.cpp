// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/place_button.h"

#include "ui/kit/command_button.h"
#include "ui/kit/theme.h"

#include <QPainter>

namespace boresight::ui {

namespace {
constexpr double kRing = 16.0;  // px
constexpr double kDot = 8.0;
constexpr int kTextLeft = 26;
}  // namespace

PlaceButton::PlaceButton(QWidget* parent) : QRadioButton(parent)
{
    setFont(fonts::text());
    setMinimumHeight(kTouchSize);
}

void PlaceButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& colours = currentTheme();
    const QPointF centre(4.0 + kRing / 2.0, height() / 2.0);
    painter.setPen(QPen(colours.text, 1.5));
    painter.setBrush(colours.plotGround);
    painter.drawEllipse(centre, kRing / 2.0, kRing / 2.0);
    if (isChecked()) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colours.accent);
        painter.drawEllipse(centre, kDot / 2.0, kDot / 2.0);
    }
    painter.setPen(colours.text);
    painter.drawText(rect().adjusted(kTextLeft, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text());
    if (hasFocus()) {
        painter.setPen(QPen(colours.accent, 1.5, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4.0, 4.0);
    }
}

}  // namespace boresight::ui

#include "moc_place_button.cpp"
