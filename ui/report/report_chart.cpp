// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_chart.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "ui/report/paper_text.h"

#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr qreal kLeftOfChart = 105.0;
constexpr qreal kHeadOfChart = 40.0;
constexpr qreal kBelowChart = 36.0;

int decimalsOf(double step)
{
    return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
}

// From values to the paper.
struct ChartScale
{
    QRectF plot;
    double least;
    double largest;
    Seconds span;

    [[nodiscard]] qreal x(Seconds since) const { return plot.left() + plot.width() * (since / span); }
    [[nodiscard]] qreal y(double value) const
    {
        return plot.bottom() - plot.height() * ((value - least) / (largest - least));
    }
};

void drawValueMarks(QPainter& painter, const ChartScale& scale)
{
    constexpr int kMost = 5;
    const double step = markStep(scale.largest - scale.least, kMost);
    for (double mark = std::ceil(scale.least / step - 1e-9) * step; mark <= scale.largest + step * 1e-6; mark += step) {
        const qreal y = scale.y(mark);
        painter.setPen(paperPen(kPaperGrid, 1.5));
        painter.drawLine(QPointF(scale.plot.left(), y), QPointF(scale.plot.right(), y));
        const QRectF room(scale.plot.left() - kLeftOfChart, y - 16.0, kLeftOfChart - 10.0, 32.0);
        drawPaperText(painter, room,
                      {.text = toQString(formatFixed(mark, decimalsOf(step))),
                       .size = kSmallLetters,
                       .colour = kFaintInk,
                       .alignment = Qt::AlignRight | Qt::AlignVCenter});
    }
}

void drawTimeMarks(QPainter& painter, const ChartScale& scale, const ReportChart& chart)
{
    constexpr int kMost = 7;
    constexpr qreal kLabelWidth = 180.0;
    const Seconds step = timeStep(scale.span, kMost);
    for (Seconds mark = step * std::ceil(chart.phase / step) - chart.phase; mark <= scale.span; mark += step) {
        const qreal x = scale.x(mark);
        painter.setPen(paperPen(kPaperGrid, 1.5));
        painter.drawLine(QPointF(x, scale.plot.top()), QPointF(x, scale.plot.bottom()));
        if (chart.timeText) {
            const qreal most = scale.plot.right() - kLabelWidth;
            const qreal left = std::clamp(x - 0.5 * kLabelWidth, scale.plot.left(), most);
            const Qt::Alignment side = left > x - 0.5 * kLabelWidth   ? Qt::AlignLeft
                                       : left < x - 0.5 * kLabelWidth ? Qt::AlignRight
                                                                      : Qt::AlignHCenter;
            drawPaperText(painter, {left, scale.plot.bottom() + 4.0, kLabelWidth, kBelowChart - 4.0},
                          {.text = chart.timeText(mark),
                           .size = kSmallLetters,
                           .colour = kFaintInk,
                           .alignment = side | Qt::AlignVCenter});
        }
    }
}

void drawTracePieces(QPainter& painter, const ChartScale& scale, const pass_report::TraceLine& line)
{
    for (const auto& piece : line) {
        QPolygonF way;
        for (const pass_report::TracePoint& point : piece) {
            // Far outside of the chart the drawing would lose its accuracy.
            const double margin = scale.largest - scale.least;
            const double value = std::clamp(point.value, scale.least - margin, scale.largest + margin);
            way << QPointF(scale.x(point.since), scale.y(value));
        }
        way.size() > 1 ? painter.drawPolyline(way) : painter.drawPoints(way);
    }
}

void drawTraceLine(QPainter& painter, const ChartScale& scale, const ReportChart::Line& line)
{
    QColor colour = line.colour;
    if (line.isBand) {
        constexpr float kLight = 0.3F;
        colour.setAlphaF(kLight);
    }
    painter.setPen(paperPen(colour, line.isBand ? 2.0 : 3.0));
    drawTracePieces(painter, scale, line.points);
    painter.setPen(paperPen(line.colour, 3.5));
    drawTracePieces(painter, scale, line.mean);
}

void drawBound(QPainter& painter, const ChartScale& scale, const ReportChart& chart)
{
    if (!chart.bound || *chart.bound > chart.largest || *chart.bound < chart.least) {
        return;
    }
    const qreal y = scale.y(*chart.bound);
    painter.setPen(paperPen(kBoundInk, 2.5, Qt::DashLine));
    painter.drawLine(QPointF(scale.plot.left(), y), QPointF(scale.plot.right(), y));
}

}  // namespace

double markStep(double span, int most)
{
    const double least = std::max(span, 1e-9) / std::max(most, 1);
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1.0 - 1e-9)) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

Seconds timeStep(Seconds span, int most)
{
    constexpr std::array kSteps{1.0,   2.0,   5.0,   10.0,   20.0,   30.0,   60.0,
                                120.0, 300.0, 600.0, 1200.0, 1800.0, 3600.0, 7200.0};
    const double least = span.count() / std::max(most, 1);
    const auto* const found = std::ranges::find_if(kSteps, [least](double step) { return step >= least; });
    return Seconds(found != kSteps.end() ? *found : 3600.0 * markStep(span.count() / 3600.0, most));
}

void drawReportChart(QPainter& painter, const QRectF& room, const ReportChart& chart)
{
    const qreal below = chart.timeText ? kBelowChart : 8.0;
    const ChartScale scale{.plot = room.adjusted(kLeftOfChart, kHeadOfChart, 0.0, -below),
                           .least = chart.least,
                           .largest = std::max(chart.largest, chart.least + 1e-9),
                           .span = std::max(chart.span, Seconds(1e-3))};
    const QRectF head(scale.plot.left(), room.top(), scale.plot.width(), kHeadOfChart);
    drawPaperText(painter, head, {.text = chart.title, .size = kTableLetters, .isBold = true});
    drawPaperText(painter, head.adjusted(head.width() * 0.5, 0.0, 0.0, 0.0),
                  {.text = chart.boundText,
                   .size = kSmallLetters,
                   .colour = kBoundInk,
                   .alignment = Qt::AlignRight | Qt::AlignVCenter});
    drawValueMarks(painter, scale);
    drawTimeMarks(painter, scale, chart);
    painter.save();
    painter.setClipRect(scale.plot);
    for (const ReportChart::Line& line : chart.lines) {
        drawTraceLine(painter, scale, line);
    }
    drawBound(painter, scale, chart);
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(paperPen(kFaintInk, 2.0));
    painter.drawRect(scale.plot);
}

}  // namespace boresight::ui
