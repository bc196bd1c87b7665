// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/limits/limit_bar.h"

#include "ui/kit/theme.h"
#include "ui/kit/travel_scale.h"

#include <QPainter>

namespace boresight::ui {

namespace {

constexpr double kLimitBarBar = 10.0;  // px
constexpr double kPointer = 6.0;       // half its width, and its height

}  // namespace

QSize LimitBar::sizeHint() const
{
    return {160, static_cast<int>(kPointer + kLimitBarBar) + QFontMetrics(fonts::label()).height() + 6};
}

QSize LimitBar::minimumSizeHint() const
{
    return {100, sizeHint().height()};
}

void LimitBar::setRanges(const TravelRange& travel, const TravelRange& inForce, const TravelRange& edited)
{
    if (travel != m_travel || inForce != m_inForce || edited != m_edited) {
        m_travel = travel;
        m_inForce = inForce;
        m_edited = edited;
        update();
    }
}

void LimitBar::setActual(const std::optional<Angle>& actual, Freshness freshness)
{
    const std::optional<Angle> shown = freshness == Freshness::NoData ? std::nullopt : actual;
    if (shown != m_actual || freshness != m_freshness) {
        m_actual = shown;
        m_freshness = freshness;
        update();
    }
}

void LimitBar::paintEvent(QPaintEvent*)
{
    const double cap = TravelScale::kCap;
    const QRectF box(cap + 2.0, kPointer + 2.0, width() - 2.0 * cap - 4.0, kLimitBarBar);
    const TravelScale scale(m_travel, box);
    if (scale.isEmpty() || box.width() < 1.0) {
        return;
    }
    const Theme& colours = currentTheme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(fonts::label());
    scale.draw(painter);
    for (const auto& [from, to] : {std::pair(m_travel.min, m_inForce.min), std::pair(m_inForce.max, m_travel.max)}) {
        if (from < to) {
            const QRectF closed(QPointF(scale.pixel(from), box.top()), QPointF(scale.pixel(to), box.bottom()));
            painter.fillRect(closed, QBrush(colours.secondary, Qt::BDiagPattern));
        }
    }
    painter.setPen(QPen(colours.accent, 2.0, Qt::DashLine));
    for (const auto& [was, is] : {std::pair(m_inForce.min, m_edited.min), std::pair(m_inForce.max, m_edited.max)}) {
        if (was != is) {
            const double x = scale.pixel(is);
            painter.drawLine(QPointF(x, box.top() - 4.0), QPointF(x, box.bottom() + 4.0));
        }
    }
    if (m_actual) {
        const QPointF tip(scale.pixel(*m_actual), box.top() + 2.0);
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_freshness == Freshness::Live ? colours.text : colours.secondary);
        painter.drawPolygon(
            QPolygonF({tip, tip - QPointF(kPointer, kPointer + 3.0), tip + QPointF(kPointer, -kPointer - 3.0)}));
    }
}

}  // namespace boresight::ui

#include "moc_limit_bar.cpp"
