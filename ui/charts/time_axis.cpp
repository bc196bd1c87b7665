// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/time_axis.h"

#include "core/base/clock.h"
#include "ui/kit/theme.h"

#include <QPainter>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr int kTimeAxisTick = 4;  // px

}  // namespace

std::chrono::seconds timeStep(std::chrono::seconds window)
{
    using namespace std::chrono_literals;
    return window <= 10s ? 2s : window <= 60s ? 15s : window <= 5min ? 1min : 10min;
}

QString timeText(std::chrono::seconds time)
{
    return time < std::chrono::minutes(1) || time % std::chrono::minutes(1) != std::chrono::seconds(0)
               ? TimeAxis::tr("%1 s").arg(time.count())
               : TimeAxis::tr("%1 min").arg(time / std::chrono::minutes(1));
}

TimeAxis::TimeAxis(QWidget* parent) : QWidget(parent)
{
    setFont(fonts::label());
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void TimeAxis::setWindow(std::chrono::seconds window)
{
    m_window = window;
    update();
}

void TimeAxis::setNewest(const QString& text)
{
    if (text != m_newest) {
        m_newest = text;
        update();
    }
}

void TimeAxis::setCanvas(int left, int width)
{
    if (left != m_left || width != m_width) {
        m_left = left;
        m_width = width;
        update();
    }
}

void TimeAxis::setCursor(int x, const QString& text)
{
    if (x != m_cursorX || text != m_cursorText) {
        m_cursorX = x;
        m_cursorText = text;
        update();
    }
}

QSize TimeAxis::sizeHint() const
{
    return {100, fontMetrics().height() + kTimeAxisTick + 2};
}

QRect TimeAxis::labelBox(double x, const QString& text) const
{
    const QSize size(fontMetrics().horizontalAdvance(text) + 8, fontMetrics().height());
    const int left = std::clamp(static_cast<int>(x) - size.width() / 2, 0, std::max(0, width() - size.width()));
    return {QPoint(left, kTimeAxisTick + 1), size};
}

// The text of the cursor has priority over the labels of the axis.
void TimeAxis::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QRect cursor = m_cursorText.isEmpty() ? QRect() : labelBox(m_cursorX, m_cursorText);
    painter.setPen(currentTheme().secondary);
    for (std::chrono::seconds ago = m_window; ago.count() >= 0; ago -= timeStep(m_window)) {
        const double x = m_left + m_width * (1.0 - Seconds(ago) / Seconds(m_window));
        painter.drawLine(QPointF(x, 0.0), QPointF(x, kTimeAxisTick));
        const QString text = ago.count() == 0 ? m_newest : QStringLiteral("−") + timeText(ago);
        if (const QRect box = labelBox(x, text); !box.intersects(cursor)) {
            painter.drawText(box, Qt::AlignCenter, text);
        }
    }
    painter.setPen(currentTheme().accent);
    painter.drawText(cursor, Qt::AlignCenter, m_cursorText);
}

}  // namespace boresight::ui

#include "moc_time_axis.cpp"
