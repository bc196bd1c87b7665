// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"

#include <QPointF>
#include <qwt_plot_item.h>

#include <memory>
#include <vector>

class QPainter;

// What lies in the deviation plot, as a Qwt item; x is the true heading, y the error, both in degrees. Included by
// deviation_plot.cpp only.
namespace boresight::ui {

class SwingItem final : public QwtPlotItem
{
public:
    // One or the other: what a swing has found, or its readings as they come.
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

// The mark of a sample shows which way the mount turned. A sample that was left out is a cross. Also for the legend.
enum class SampleShape
{
    Clockwise,
    Back,
    LeftOut
};

void drawSample(QPainter& painter, SampleShape shape, QPointF at);

}  // namespace boresight::ui
