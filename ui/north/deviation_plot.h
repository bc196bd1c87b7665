// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"

#include <QWidget>

#include <memory>
#include <vector>

class QwtPlot;
class QwtPlotGrid;

// The curve that a compass swing has found: the error of the sensor by the true heading, the samples of both
// directions, and their distance from the curve. Apart from the polar plot and the strip charts the only user of Qwt.
namespace boresight::ui {

class SwingItem;

class DeviationPlot : public QWidget
{
    Q_OBJECT

public:
    explicit DeviationPlot(QWidget* parent = nullptr);
    ~DeviationPlot() override;

    void showSwing(std::shared_ptr<const SwingOutcome> swing);  // null: no swing
    // During a swing, in place of the curve: the readings so far, possibly thinned, and the report of the run about all
    // of them.
    void showDots(const std::vector<calibration::SwingDot>& dots, const QString& said);

    [[nodiscard]] QPointF pixel(Angle heading, Angle error) const;  // for the test of the painting
    // The ends of the scale, in degrees.
    [[nodiscard]] double lowest() const { return m_lowest; }
    [[nodiscard]] double highest() const { return m_highest; }

    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 110}; }
    [[nodiscard]] QSize sizeHint() const override { return {300, 140}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void setUpPlot();
    void setColours();
    void fitScale();

    std::shared_ptr<const SwingOutcome> m_swing;
    std::vector<calibration::SwingDot> m_dots;
    bool m_turns = false;  // dots are shown
    double m_lowest = -10.0;
    double m_highest = 10.0;
    std::unique_ptr<QwtPlotGrid> m_grid;
    std::unique_ptr<SwingItem> m_item;
    QwtPlot* m_plot;
};

}  // namespace boresight::ui
