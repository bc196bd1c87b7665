// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/plot_button.h"

#include "ui/kit/theme.h"

#include <QPainter>
#include <QPainterPath>

namespace boresight::ui {

namespace {

constexpr double kCornerRadius = 6.0;  // px
constexpr double kStroke = 1.6;

// Each symbol is in a square of 20 px around the origin.
QPainterPath pencil()
{
    QPainterPath path;
    path.addPolygon(
        QPolygonF({QPointF(-7, 7), QPointF(-6, 3), QPointF(4, -7), QPointF(7, -4), QPointF(-3, 6), QPointF(-7, 7)}));
    path.moveTo(1.5, -4.5);
    path.lineTo(4.5, -1.5);
    return path;
}

QPainterPath lens()
{
    QPainterPath path;
    path.addEllipse(QPointF(-1.5, -1.5), 5.5, 5.5);
    path.moveTo(2.6, 2.6);
    path.lineTo(7.5, 7.5);
    return path;
}

QPainterPath arrowIntoTray()
{
    QPainterPath path;
    path.moveTo(0, -8);
    path.lineTo(0, 3);
    path.moveTo(-4, -1);
    path.lineTo(0, 3);
    path.lineTo(4, -1);
    path.moveTo(-7, 4);
    path.lineTo(-7, 7);
    path.lineTo(7, 7);
    path.lineTo(7, 4);
    return path;
}

QPainterPath pathOf(PlotButton::Glyph glyph)
{
    switch (glyph) {
        case PlotButton::Glyph::Edit:
            return pencil();
        case PlotButton::Glyph::Zoom:
            return lens();
        case PlotButton::Glyph::Save:
            return arrowIntoTray();
    }
    return {};
}

}  // namespace

PlotButton::PlotButton(Glyph glyph, const QString& text, const QString& help, QWidget* parent)
    : QToolButton(parent), m_glyph(glyph)
{
    setText(text);
    setToolTip(help);
    setAccessibleName(help);
    setCheckable(glyph != Glyph::Save);
    setFocusPolicy(Qt::TabFocus);
    setFixedSize(kSize, kSize);
}

void PlotButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& colours = currentTheme();
    const bool pressed = isDown() || isChecked();
    painter.setPen(QPen(pressed || underMouse() ? colours.accent : colours.grid, 1.0));
    painter.setBrush(pressed ? colours.accent : colours.plotGround);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCornerRadius, kCornerRadius);
    if (hasFocus()) {
        painter.setPen(QPen(pressed ? colours.plotGround : colours.accent, 2.0));
        painter.drawRoundedRect(QRectF(rect()).adjusted(3.0, 3.0, -3.0, -3.0), kCornerRadius - 2, kCornerRadius - 2);
    }
    painter.translate(QRectF(rect()).center());
    painter.setPen(
        QPen(pressed ? colours.plotGround : colours.text, kStroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(pathOf(m_glyph));
}

}  // namespace boresight::ui

#include "moc_plot_button.cpp"
