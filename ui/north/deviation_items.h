// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"

#include <QPointF>
#include <qwt_plot_item.h>

#include <memory>
#include <vector>

class QPainter;

// The contents of the deviation plot as a Qwt item. x is the true heading, y the error, both in degrees. Only
// deviation_plot.cpp includes this file.
namespace boresight::ui {

class SwingItem final : public QwtPlotItem
{
public:
    // One of the two: the result of a swing, or its readings as they arrive.
    void setSwing(std::shared_ptr<const SwingOutcome> swing) { m_swing = std::move(swing); }
    void setDots(std::vector<calibration::SwingDot> dots) { m_dots = std::move(dots); }

    void draw(QPainter* painter, const QwtScaleMap& headingMap, const QwtScaleMap& errorMap,
              const QRectF& canvas) const override;

private:
    void drawUnreliable(QPainter& painter, const QwtScaleMap& headingMap, const QRectF& canvas) const;
    void drawCurve(QPainter& painter, const QwtScaleMap& headingMap, const QwtScaleMap& errorMap) const;
    void drawDots(QPainter& painter, const QwtScaleMap& headingMap, const QwtScaleMap& errorMap,
                  const QRectF& canvas) const;
    void drawSamples(QPainter& painter, const QwtScaleMap& headingMap, const QwtScaleMap& errorMap,
                     const QRectF& canvas) const;

    std::shared_ptr<const SwingOutcome> m_swing;
    std::vector<calibration::SwingDot> m_dots;
};

// The mark of a sample shows in which direction the mount turned. A sample that was left out is a cross. Also used for
// the legend.
enum class SampleShape
{
    Clockwise,
    Back,
    LeftOut
};

void drawSample(QPainter& painter, SampleShape shape, QPointF at);

}  // namespace boresight::ui
