// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/error_bar.h"

#include "ui/kit/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr int kBarHeight = 12;    // px
constexpr double kGroove = 4.0;   // px
constexpr double kDot = 5.0;      // px, half its size
constexpr double kMiddle = 10.0;  // px, the tick of the target

}  // namespace

ErrorBar::ErrorBar(const QString& accessibleName, QWidget* parent) : QWidget(parent)
{
    setAccessibleName(accessibleName);
    setFixedHeight(kBarHeight);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("Error in beam widths. The middle is the target. Each end is one beam width."));
}

void ErrorBar::setError(const std::optional<double>& share, bool unplanned)
{
    if (share == m_share && unplanned == m_unplanned) {
        return;
    }
    m_share = share;
    m_unplanned = unplanned;
    setAccessibleDescription(share ? tr("%1 beam widths").arg(*share, 0, 'f', 2) : QString());
    update();
}

void ErrorBar::paintEvent(QPaintEvent*)
{
    const Theme& theme = currentTheme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double y = 0.5 * height();
    const double reach = 0.5 * width() - kDot;
    const double middle = 0.5 * width();
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.grid);
    painter.drawRoundedRect(QRectF(0.0, y - 0.5 * kGroove, width(), kGroove), 0.5 * kGroove, 0.5 * kGroove);
    painter.setBrush(theme.secondary);
    painter.drawRect(QRectF(middle - 0.75, y - 0.5 * kMiddle, 1.5, kMiddle));
    if (!m_share) {
        return;
    }
    painter.setBrush(m_unplanned ? theme.warning : theme.accent);
    const double x = middle + std::clamp(*m_share, -1.0, 1.0) * reach;
    if (std::abs(*m_share) <= 1.0) {
        painter.drawEllipse(QPointF(x, y), kDot, kDot);
        return;
    }
    const double point = std::copysign(kDot, *m_share);
    painter.drawPolygon(QPolygonF({{x + point, y}, {x - point, y - kDot}, {x - point, y + kDot}}));
}

}  // namespace boresight::ui

#include "moc_error_bar.cpp"
