// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/strip_frame.h"

#include <qwt_plot_item.h>
#include <qwt_scale_draw.h>

// What lies in a strip, as Qwt items. Included by strip_chart.cpp only, so that Qwt stays in one place. A column of the
// frame is one pixel of the screen.
namespace boresight::ui {

// The traces: bands first, lines above them.
class TracesItem final : public QwtPlotItem
{
public:
    void setFrame(const StripFrame& frame) { m_frame = &frame; }  // outlives the item

    void draw(QPainter* painter, const QwtScaleMap& timeMap, const QwtScaleMap& valueMap,
              const QRectF& canvasRect) const override;

private:
    const StripFrame* m_frame = nullptr;
};

// Reference lines with their words, below the traces, and the cursor.
class MarksItem final : public QwtPlotItem
{
public:
    void setFrame(const StripFrame& frame) { m_frame = &frame; }

    void draw(QPainter* painter, const QwtScaleMap& timeMap, const QwtScaleMap& valueMap,
              const QRectF& canvasRect) const override;

private:
    const StripFrame* m_frame = nullptr;
};

// Labels that all have the same decimals.
class ValueScaleDraw final : public QwtScaleDraw
{
public:
    void setDecimals(int decimals);
    [[nodiscard]] QwtText label(double value) const override;

private:
    int m_decimals = 0;
};

// As in the strip: for the legend beside its word.
[[nodiscard]] QPen tracePen(TraceLine line);

}  // namespace boresight::ui
