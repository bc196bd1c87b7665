// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPen>
#include <QPolygonF>
#include <qwt_plot_item.h>

#include <utility>
#include <vector>

// One curve of the response chart as a Qwt item. x in seconds, y in the unit of the chart. The curve has gaps where the
// drive reported no value. Only response_chart.cpp includes this file.
namespace boresight::ui {

class ResponseItem final : public QwtPlotItem
{
public:
    void setPieces(std::vector<QPolygonF> pieces) { m_pieces = std::move(pieces); }
    void setPen(const QPen& pen) { m_pen = pen; }
    [[nodiscard]] const QPen& pen() const { return m_pen; }

    void draw(QPainter* painter, const QwtScaleMap& timeMap, const QwtScaleMap& valueMap,
              const QRectF& canvas) const override;

private:
    std::vector<QPolygonF> m_pieces;
    QPen m_pen;
};

}  // namespace boresight::ui
