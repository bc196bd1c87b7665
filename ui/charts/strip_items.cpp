// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/strip_items.h"

#include "ui/kit/theme.h"

#include <QPainter>
#include <qwt_scale_map.h>
#include <qwt_text.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace boresight::ui {

namespace {

constexpr double kItemLineWidth = 1.5;
constexpr double kBandWidth = 6.0;
constexpr std::size_t kPiece = 48;      // columns
constexpr double kBandStrength = 0.45;  // of the accent colour over the ground

QColor mixed(const QColor& colour, const QColor& ground, double share)
{
    const auto part = [share](int a, int b) { return static_cast<int>(std::lround(share * a + (1.0 - share) * b)); };
    return {part(colour.red(), ground.red()), part(colour.green(), ground.green()), part(colour.blue(), ground.blue())};
}

struct Edges  // upper and lower edge of a curve in one column, in pixels from above
{
    double x = 0.0;
    double upper = 0.0;
    double lower = 0.0;
};

// A curve as the area between its edges, in time steps of one pixel. This is several times faster than a pen that moves
// between the peaks, and equally smooth, because the edges are not rounded to pixels.
void fillPiece(QPainter& painter, std::span<const Edges> piece, double columnWidth, double halfWidth)
{
    QPolygonF area;
    area.reserve(static_cast<qsizetype>(piece.size() * 4));
    for (const Edges& edges : piece) {
        area << QPointF(edges.x, edges.upper - halfWidth) << QPointF(edges.x + columnWidth, edges.upper - halfWidth);
    }
    for (auto edges = piece.rbegin(); edges != piece.rend(); ++edges) {
        area << QPointF(edges->x + columnWidth, edges->lower + halfWidth)
             << QPointF(edges->x, edges->lower + halfWidth);
    }
    painter.drawPolygon(area, Qt::WindingFill);
}

// In pieces, because the time of Qt's rasteriser grows with the square of the width: it searches its cells along the
// whole row. The pieces overlap by a column, so that no seam is visible where a column is not a whole pixel.
void fillRun(QPainter& painter, std::span<const Edges> run, double columnWidth, double halfWidth)
{
    for (std::size_t first = 0; first < run.size(); first += kPiece) {
        fillPiece(painter, run.subspan(first, std::min(kPiece + 1, run.size() - first)), columnWidth, halfWidth);
    }
}

// One area for each run without a gap. A column reaches back to the one before it, so a jump becomes a line.
void drawTrace(QPainter& painter, const Trace& trace, const StripFrame& frame, const QwtScaleMap& valueMap,
               const QRectF& canvas)
{
    const double columnWidth = canvas.width() / static_cast<double>(frame.columns);
    const double halfWidth = tracePen(trace.line).widthF() / 2.0;
    std::vector<Edges> run;
    std::int64_t before = 0;
    for (const PeakColumn& column : trace.columns) {
        Edges edges{.x = canvas.left() + static_cast<double>(column.column - frame.firstColumn) * columnWidth,
                    .upper = valueMap.transform(static_cast<double>(column.range.max)),
                    .lower = valueMap.transform(static_cast<double>(column.range.min))};
        if (!column.joined) {
            fillRun(painter, run, columnWidth, halfWidth);
            run.clear();
        } else if (column.column == before + 1) {
            edges.upper = std::min(edges.upper, run.back().lower);
            edges.lower = std::max(edges.lower, run.back().upper);
        }
        run.push_back(edges);
        before = column.column;
    }
    fillRun(painter, run, columnWidth, halfWidth);
}

}  // namespace

QPen tracePen(TraceLine line)
{
    const Theme& colours = currentTheme();
    return line == TraceLine::Line ? QPen(colours.text, kItemLineWidth, Qt::SolidLine, Qt::SquareCap, Qt::BevelJoin)
                                   : QPen(mixed(colours.accent, colours.plotGround, kBandStrength), kBandWidth,
                                          Qt::SolidLine, Qt::SquareCap, Qt::BevelJoin);
}

void TracesItem::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap& valueMap,
                      const QRectF& canvasRect) const
{
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    for (const TraceLine line : {TraceLine::Band, TraceLine::Line}) {
        painter->setBrush(tracePen(line).color());
        for (const Trace& trace : m_frame->traces) {
            if (trace.line == line) {
                drawTrace(*painter, trace, *m_frame, valueMap, canvasRect);
            }
        }
    }
}

void MarksItem::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap& valueMap, const QRectF& canvasRect) const
{
    const Theme& colours = currentTheme();
    painter->setFont(fonts::label());
    for (const ReferenceLine& line : m_frame->references) {
        const double y = std::round(valueMap.transform(line.value));
        if (y < canvasRect.top() + 1.0 || y > canvasRect.bottom() - 1.0) {
            continue;
        }
        painter->setPen(QPen(colours.warning, 1.0, Qt::DashLine));
        painter->drawLine(QPointF(canvasRect.left(), y), QPointF(canvasRect.right(), y));
        painter->setPen(colours.warning);
        const double height = painter->fontMetrics().height();
        const double top = y - height < canvasRect.top() ? y : y - height;
        painter->drawText(QRectF(canvasRect.left() + 4.0, top, canvasRect.width() - 8.0, height),
                          Qt::AlignLeft | Qt::AlignVCenter, line.text);
    }
    if (m_frame->cursor) {
        const double x =
            canvasRect.left() + (*m_frame->cursor + 0.5) * canvasRect.width() / static_cast<double>(m_frame->columns);
        painter->setPen(QPen(colours.accent, 1.0));
        painter->drawLine(QPointF(x, canvasRect.top()), QPointF(x, canvasRect.bottom()));
    }
}

void ValueScaleDraw::setDecimals(int decimals)
{
    if (decimals != m_decimals) {
        m_decimals = decimals;
        invalidateCache();
    }
}

QwtText ValueScaleDraw::label(double value) const
{
    QString text = QString::number(value, 'f', m_decimals);
    return text.toDouble() == 0.0 ? QString::number(0.0, 'f', m_decimals) : text;
}

}  // namespace boresight::ui
