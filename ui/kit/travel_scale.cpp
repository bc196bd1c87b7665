// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/travel_scale.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"

#include <QFontMetrics>
#include <QPainter>

#include <cmath>

namespace boresight::ui {

double TravelScale::pixel(Angle angle) const
{
    return m_box.left() + (m_travel.clamped(angle) - m_travel.min) / (m_travel.max - m_travel.min) * m_box.width();
}

void TravelScale::draw(QPainter& painter) const
{
    const Theme& colours = currentTheme();
    painter.fillRect(m_box, colours.plotGround);
    for (const QRectF& cap : {QRectF(m_box.left() - kCap, m_box.top(), kCap, m_box.height()),
                              QRectF(m_box.right(), m_box.top(), kCap, m_box.height())}) {
        painter.fillRect(cap, QBrush(colours.secondary, Qt::BDiagPattern));
    }
    painter.setPen(colours.secondary);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(m_box.adjusted(-kCap, 0, kCap, 0));
    drawTicks(painter);
}

void TravelScale::drawTicks(QPainter& painter) const
{
    const Angle step = m_travel.max - m_travel.min > 180_deg ? 90_deg : 30_deg;
    const int first = static_cast<int>(std::ceil(m_travel.min / step));
    const int last = static_cast<int>(std::floor(m_travel.max / step));
    const QFontMetrics metrics = painter.fontMetrics();
    const int labelWidth = metrics.horizontalAdvance(QStringLiteral("-000°"));
    for (int tick = first; tick <= last; ++tick) {
        const Angle angle = step * tick;
        const double x = pixel(angle);
        painter.drawLine(QPointF(x, m_box.top()), QPointF(x, m_box.bottom() + (tick == 0 ? 4 : 2)));
        if (tick % 2 == 0 || m_box.width() > 1.2 * labelWidth * (last - first + 1)) {
            painter.drawText(QRectF(x - labelWidth, m_box.bottom() + 2, 2.0 * labelWidth, metrics.height()),
                             Qt::AlignHCenter | Qt::AlignTop, angleText(angle, 0));
        }
    }
}

}  // namespace boresight::ui
