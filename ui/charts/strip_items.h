// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/strip_frame.h"

#include <qwt_plot_item.h>
#include <qwt_scale_draw.h>

// The contents of a strip as Qwt items. Only strip_chart.cpp includes this file, so that Qwt stays in one place. A
// column of the frame is one pixel of the screen.
namespace boresight::ui {

// The traces: bands first, lines on top of them.
class TracesItem final : public QwtPlotItem
{
public:
    void setFrame(const StripFrame& frame) { m_frame = &frame; }  // must outlive the item

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

// Labels with the same number of decimals.
class ValueScaleDraw final : public QwtScaleDraw
{
public:
    void setDecimals(int decimals);
    [[nodiscard]] QwtText label(double value) const override;

private:
    int m_decimals = 0;
};

// The pen of a trace, also used in the legend.
[[nodiscard]] QPen tracePen(TraceLine line);

}  // namespace boresight::ui
