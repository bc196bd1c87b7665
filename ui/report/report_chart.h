// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pass_report/pass_trace.h"

#include <QColor>
#include <QPainter>
#include <QRectF>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

// A value over the time of a pass, on paper. Any thread with a QGuiApplication.
namespace boresight::ui {

struct ReportChart
{
    struct Line
    {
        pass_report::TraceLine points;
        QColor colour;
        bool isBand = false;  // light, with `mean` as a dark line
        pass_report::TraceLine mean = {};
    };

    QString title;  // with the unit
    std::vector<Line> lines;
    double least = 0.0;
    double largest = 1.0;  // a line above or below is cut
    Seconds span{};
    Seconds phase{};              // the time at the left edge. The marks are at round times
    std::optional<double> bound;  // a line across the chart
    QString boundText;
    std::function<QString(Seconds)> timeText;  // of the time since the left edge; empty: no texts below the chart
};

// A round distance between the marks of an axis: 1, 2 or 5 times a power of ten, with at most `most` of them in `span`.
[[nodiscard]] double markStep(double span, int most);
// The same for times: seconds, minutes or hours.
[[nodiscard]] Seconds timeStep(Seconds span, int most);

void drawReportChart(QPainter& painter, const QRectF& room, const ReportChart& chart);

}  // namespace boresight::ui
