// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/paint.h"

#include "ui/kit/theme.h"

#include <QPainter>
#include <QStyleOption>
#include <QVariant>
#include <QWidget>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr const char* kEmphasis = "emphasis";
constexpr double kFocusWidth = 2.0;  // px
constexpr double kFieldRounding = 6.0;

QRectF inPixels(const QRectF& box)
{
    return box.adjusted(0.5, 0.5, -0.5, -0.5);
}

bool isEnabled(const QStyleOption& option)
{
    return option.state.testFlag(QStyle::State_Enabled);
}

bool isHeld(const QStyleOption& option)
{
    return (option.state & (QStyle::State_Sunken | QStyle::State_On)).toInt() != 0;
}

bool isHovered(const QStyleOption& option)
{
    return isEnabled(option) && option.state.testFlag(QStyle::State_MouseOver);
}

QColor between(const QColor& a, const QColor& b, float share)
{
    return QColor::fromRgbF(a.redF() + (b.redF() - a.redF()) * share, a.greenF() + (b.greenF() - a.greenF()) * share,
                            a.blueF() + (b.blueF() - a.blueF()) * share);
}

void round(QPainter& painter, const QRectF& box, double rounding, const QPen& edge, const QBrush& ground)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(edge);
    painter.setBrush(ground);
    painter.drawRoundedRect(box, rounding, rounding);
    painter.restore();
}

void frame(QPainter& painter, const QRectF& box, const QColor& colour)
{
    const double in = kFocusWidth / 2.0;
    round(painter, box.adjusted(in, in, -in, -in), kFieldRounding, QPen(colour, kFocusWidth), Qt::NoBrush);
}

}  // namespace

void setEmphasis(QWidget& button, Emphasis emphasis)
{
    button.setProperty(kEmphasis, static_cast<int>(emphasis));
}

Emphasis emphasisOf(const QWidget* button)
{
    return button == nullptr ? Emphasis::Normal : static_cast<Emphasis>(button->property(kEmphasis).toInt());
}

void paintCard(QPainter& painter, const QRectF& box)
{
    const Theme& colours = currentTheme();
    round(painter, inPixels(box), kRounding, QPen(between(colours.card, colours.hairline, 0.5F)), colours.card);
}

void paintFocus(QPainter& painter, const QRectF& box)
{
    frame(painter, box, currentTheme().accent);
}

void paintButton(QPainter& painter, const QStyleOption& option, Emphasis emphasis)
{
    const Theme& colours = currentTheme();
    const QRectF box = inPixels(option.rect);
    if (isHeld(option)) {
        round(painter, box, kRounding, QPen(colours.accent), colours.accentSoft);
    } else if (!isEnabled(option)) {  // its words are dimmed, too
        const bool hasEdge = emphasis != Emphasis::Quiet;
        round(painter, box, kRounding, hasEdge ? QPen(between(colours.card, colours.hairline, 0.5F)) : QPen(Qt::NoPen),
              Qt::NoBrush);
    } else if (emphasis == Emphasis::Primary) {
        round(painter, box, kRounding, QPen(colours.accent),
              isHovered(option) ? between(colours.accent, colours.text, 0.15F) : colours.accent);
    } else if (emphasis == Emphasis::Quiet) {
        round(painter, box, kRounding, QPen(isHovered(option) ? colours.hairline : QColor(Qt::transparent)),
              Qt::NoBrush);
    } else {
        round(painter, box, kRounding, QPen(isHovered(option) ? colours.secondary : colours.hairline), colours.button);
    }
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        const bool isFilled = emphasis == Emphasis::Primary && isEnabled(option) && !isHeld(option);
        frame(painter, isFilled ? box.adjusted(2, 2, -2, -2) : box, isFilled ? colours.onAccent : colours.accent);
    }
}

void paintField(QPainter& painter, const QStyleOption& option)
{
    const Theme& colours = currentTheme();
    const bool isFocused = option.state.testFlag(QStyle::State_HasFocus);
    const QColor ground = isEnabled(option) ? option.palette.color(QPalette::Base) : colours.card;
    round(painter, inPixels(option.rect), kFieldRounding,
          QPen(isHovered(option) ? colours.secondary : colours.hairline), ground);
    if (isFocused) {
        paintFocus(painter, option.rect);
    }
}

void paintTab(QPainter& painter, const QStyleOption& option)
{
    const Theme& colours = currentTheme();
    const QRectF box = QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -2.5);
    if (option.state.testFlag(QStyle::State_Selected)) {
        round(painter, box, kFieldRounding, QPen(colours.hairline), colours.button);
    } else if (isHovered(option)) {
        round(painter, box, kFieldRounding, QPen(colours.hairline), Qt::NoBrush);
    }
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        paintFocus(painter, box);
    }
}

void paintBox(QPainter& painter, const QStyleOption& option, bool isRound)
{
    const Theme& colours = currentTheme();
    const bool isOn = option.state.testFlag(QStyle::State_On);
    const QColor strong = isEnabled(option) ? colours.accent : colours.secondary;
    const QRectF box = inPixels(option.rect);
    round(painter, box, isRound ? box.width() / 2.0 : 4.0, QPen(isOn ? strong : colours.secondary, 1.5),
          isOn ? strong : colours.plotGround);
    if (!isOn) {
        return;
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours.onAccent, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const auto at = [&box](double x, double y) {
        return QPointF(box.left() + x * box.width(), box.top() + y * box.height());
    };
    if (isRound) {
        painter.setBrush(colours.onAccent);
        painter.drawEllipse(box.center(), box.width() * 0.14, box.width() * 0.14);
    } else {
        painter.drawPolyline(QPolygonF({at(0.24, 0.52), at(0.43, 0.72), at(0.77, 0.3)}));
    }
    painter.restore();
}

void paintStroke(QPainter& painter, Stroke stroke, const QRectF& box, bool enabled)
{
    const double half = std::min({box.width(), box.height(), 10.0}) / 2.0;
    const QPointF c = box.center();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(
        QPen(enabled ? currentTheme().text : currentTheme().hairline, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (stroke == Stroke::Down) {
        painter.drawPolyline(
            QPolygonF({c + QPointF(-half, -half / 2.0), c + QPointF(0.0, half / 2.0), c + QPointF(half, -half / 2.0)}));
    } else {
        painter.drawLine(c - QPointF(half, 0.0), c + QPointF(half, 0.0));
    }
    if (stroke == Stroke::Plus) {
        painter.drawLine(c - QPointF(0.0, half), c + QPointF(0.0, half));
    }
    painter.restore();
}

}  // namespace boresight::ui
