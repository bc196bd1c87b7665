// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/pass_time_axis.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr std::chrono::minutes kTimeSteps[] = {std::chrono::minutes(1), std::chrono::minutes(2),
                                               std::chrono::minutes(5), std::chrono::minutes(15),
                                               std::chrono::hours(1),   std::chrono::hours(3)};
constexpr std::chrono::minutes kWidestTimeStep = std::chrono::hours(6);
constexpr double kBetweenTimes = 10.0;    // px
constexpr double kBelowThePicture = 8.0;  // px

QString toTheMinute(UtcTime utc)
{
    return clockText(utc).chopped(3);
}

}  // namespace

double PassTimeAxis::pixelOf(UtcTime utc) const
{
    return canvas.left() + Seconds(utc - first) / Seconds(last - first) * canvas.width();
}

void PassTimeAxis::paint(QPainter& painter) const
{
    const Theme& colours = currentTheme();
    const QFontMetricsF metrics(painter.font());
    const double across = metrics.horizontalAdvance(QStringLiteral("00:00")) + kBetweenTimes;
    const double acrossEnd = metrics.horizontalAdvance(QStringLiteral("00:00:00")) + kBetweenTimes;
    const auto* const step = std::ranges::find_if(kTimeSteps, [&](std::chrono::minutes one) {
        return Seconds(one) / Seconds(last - first) * canvas.width() > across;
    });
    const UtcTime::duration apart = step == std::end(kTimeSteps) ? kWidestTimeStep : *step;
    const auto label = [&](double x, double width, const QString& text) {
        const double left = std::clamp(x - width / 2.0, 0.0, std::max(room - width, 0.0));
        painter.setPen(colours.secondary);
        painter.drawText(QRectF(left, canvas.bottom() + kBelowThePicture, width, metrics.height()), Qt::AlignCenter,
                         text);
    };
    label(canvas.left(), acrossEnd, clockText(first));
    label(canvas.right(), acrossEnd, clockText(last));
    for (UtcTime at{(first.time_since_epoch() / apart + 1) * apart}; at < last; at += apart) {
        const double x = std::round(pixelOf(at)) + 0.5;
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(x, canvas.top()), QPointF(x, canvas.bottom()));
        if (x - across / 2.0 > acrossEnd && x + across / 2.0 < room - acrossEnd) {
            label(x, across, toTheMinute(at));
        }
    }
}

}  // namespace boresight::ui
