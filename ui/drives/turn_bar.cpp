// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/turn_bar.h"

#include "ui/kit/format.h"
#include "ui/kit/symbol.h"
#include "ui/kit/theme.h"
#include "ui/kit/travel_scale.h"

#include <QPainter>

namespace boresight::ui {

namespace {

constexpr double kTurnBarThickness = 14.0;  // px of the bar
constexpr double kTurnBarMark = 13.0;       // px of an open mark
constexpr double kMinimumGap = 16.0;        // px between marks that are drawn as such

}  // namespace

TurnBar::TurnBar(QWidget* parent) : QWidget(parent)
{
    setFont(fonts::label());
    setAccessibleName(tr("Possible positions of the axis"));
    setToolTip(tr("◇ possible position of the axis, ◆ chosen position. The hatched ends are outside the travel."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize TurnBar::sizeHint() const
{
    return {320, static_cast<int>(2 * fontMetrics().lineSpacing() + kTurnBarThickness + 10)};
}

void TurnBar::show(TravelRange travel, const std::vector<Angle>& candidates, std::optional<Angle> chosen)
{
    if (travel == m_travel && candidates == m_candidates && chosen == m_chosen) {
        return;
    }
    m_travel = travel;
    m_candidates = candidates;
    m_chosen = chosen;
    setAccessibleDescription(chosen ? tr("%1 places, chosen %2").arg(candidates.size()).arg(angleText(*chosen, 1))
                                    : tr("%1 places, none chosen").arg(candidates.size()));
    update();
}

QRectF TurnBar::bar() const
{
    const double margin = TravelScale::kCap + fontMetrics().horizontalAdvance(QStringLiteral("-000°")) / 2.0;
    return {margin, fontMetrics().lineSpacing() + 4.0, width() - 2.0 * margin, kTurnBarThickness};
}

TravelRange TurnBar::range() const
{
    TravelRange range = m_travel;
    for (const Angle angle : m_candidates) {
        range = {std::min(range.min, angle), std::max(range.max, angle)};
    }
    return range;
}

void TurnBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = bar();
    const TravelScale scale(range(), box);
    if (scale.isEmpty()) {
        return;
    }
    scale.draw(painter);
    const Theme& colours = currentTheme();
    const bool dense = box.width() < kMinimumGap * static_cast<double>(m_candidates.size());
    const auto around = [&](double x, double size) {
        return QRectF(x - size / 2.0, box.center().y() - size / 2.0, size, size);
    };
    for (const Angle angle : m_candidates) {
        const double x = scale.pixel(angle);
        if (dense) {
            painter.setPen(QPen(colours.secondary, 1.0));
            painter.drawLine(QPointF(x, box.top() + 3.0), QPointF(x, box.bottom() - 3.0));
        } else if (angle != m_chosen) {
            drawSymbol(painter, Symbol::Target, around(x, kTurnBarMark), colours.text);
        }
    }
    if (m_chosen) {
        const double x = scale.pixel(*m_chosen);
        const double half = box.height() / 2.0 + 2.0;
        painter.setPen(Qt::NoPen);
        painter.setBrush(colours.accent);
        const QPointF c(x, box.center().y());
        painter.drawPolygon(
            QPolygonF({c - QPointF(0, half), c + QPointF(half, 0), c + QPointF(0, half), c - QPointF(half, 0)}));
        painter.setPen(colours.accent);
        painter.drawText(QRectF(x - 60.0, 0.0, 120.0, fontMetrics().height()), Qt::AlignHCenter | Qt::AlignTop,
                         angleText(*m_chosen, 1));
    }
}

}  // namespace boresight::ui

#include "moc_turn_bar.cpp"
