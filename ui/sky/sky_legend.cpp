// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_legend.h"

#include "ui/kit/symbol.h"
#include "ui/kit/theme.h"
#include "ui/sky/sky_beam.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <vector>

namespace boresight::ui {

namespace {

constexpr double kLegendEdge = 6.0;  // px
constexpr double kBetween = 10.0;    // px between two entries of a line
constexpr std::size_t kMostInALine = 2;

class SkyLegend
{
    Q_DECLARE_TR_FUNCTIONS(SkyLegend)
};

struct Entry
{
    Symbol symbol;  // none: a piece of the line of the planned beam
    QString text;
    Tone tone;
};

using Line = std::vector<Entry>;

std::vector<Entry> entries(const LegendParts& parts)
{
    std::vector<Entry> list{{Symbol::Actual, SkyLegend::tr("actual"), Tone::Normal},
                            {Symbol::Commanded, SkyLegend::tr("commanded"), Tone::Normal},
                            {Symbol::Target, SkyLegend::tr("target"), Tone::Accent}};
    if (parts.hasSensor) {
        list.push_back({Symbol::Sensor, SkyLegend::tr("sensor"), Tone::Sensor});
    }
    if (parts.hasBeam) {
        list.push_back({Symbol::None, SkyLegend::tr("planned beam"), Tone::Accent});
    }
    return list;
}

double widthOf(const Entry& entry, const QFontMetricsF& metrics)
{
    return 1.4 * metrics.ascent() + metrics.horizontalAdvance(entry.text);
}

double widthOf(const Line& line, const QFontMetricsF& metrics)
{
    double width = kLegendEdge;
    for (const Entry& entry : line) {
        width += widthOf(entry, metrics) + (&entry == line.data() ? 0.0 : kBetween);
    }
    return width;
}

// From the bottom upwards, because a corner beside a disc is widest at the bottom.
std::vector<Line> linesFromBelow(const SkyFrame& frame, const QFontMetricsF& metrics, const LegendParts& parts)
{
    std::vector<Entry> left = entries(parts);
    std::vector<Line> lines;
    while (!left.empty()) {
        const double from = static_cast<double>(lines.size()) * metrics.lineSpacing();
        const double room = frame.freeWidth(SkyCorner::LowerLeft, from, from + metrics.lineSpacing());
        Line line{left.back()};
        left.pop_back();
        while (!left.empty() && line.size() < kMostInALine) {
            line.insert(line.begin(), left.back());
            if (widthOf(line, metrics) > room) {
                line.erase(line.begin());
                break;
            }
            left.pop_back();
        }
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

double legendHeight(const SkyFrame& frame, const LegendParts& parts)
{
    const QFontMetricsF metrics(fonts::label());
    return static_cast<double>(linesFromBelow(frame, metrics, parts).size()) * metrics.lineSpacing() + 4.0;
}

void paintLegend(QPainter& painter, const QRectF& view, const SkyFrame& frame, const LegendParts& parts)
{
    painter.save();
    painter.setFont(fonts::label());
    const QFontMetricsF metrics(painter.font());
    const Theme& colours = currentTheme();
    double bottom = view.bottom() - 2.0;
    for (const Line& line : linesFromBelow(frame, metrics, parts)) {
        const QRectF ground(view.left(), bottom - metrics.lineSpacing(), widthOf(line, metrics) + 4.0,
                            metrics.lineSpacing());
        painter.fillRect(ground, colours.window);
        double x = view.left() + kLegendEdge;
        const double size = metrics.ascent();
        for (const Entry& entry : line) {
            if (entry.symbol == Symbol::None) {
                painter.setPen(SkyBeam::pen());
                painter.drawLine(QPointF(x, ground.center().y()), QPointF(x + size, ground.center().y()));
            } else {
                drawSymbol(painter, entry.symbol, QRectF(x, ground.top() + 1.5, size, size).adjusted(1, 1, -1, -1),
                           colours.colour(entry.tone));
            }
            painter.setPen(colours.secondary);
            painter.drawText(QPointF(x + 1.4 * size, ground.top() + metrics.ascent()), entry.text);
            x += widthOf(entry, metrics) + kBetween;
        }
        bottom = ground.top();
    }
    painter.restore();
}

}  // namespace boresight::ui
