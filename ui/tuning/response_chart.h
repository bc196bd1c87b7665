// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tuning/tuning_words.h"

#include <QWidget>

#include <memory>

class QwtPlot;
class QwtPlotGrid;

// The response of an axis in a run, before and after a change of the gains: its tracking error or its torque over time.
// Apart from the polar plot, the strip charts and the deviation plot the only user of Qwt.
namespace boresight::ui {

class ResponseItem;

class ResponseChart : public QWidget
{
    Q_OBJECT

public:
    enum class Quantity
    {
        Error,  // °
        Torque  // Nm
    };

    explicit ResponseChart(QWidget* parent = nullptr);
    ~ResponseChart() override;

    void show(const BeforeAndAfter& results);
    void choose(Quantity quantity);
    [[nodiscard]] double highest() const { return m_highest; }  // end of the scale, on both sides

    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 90}; }
    [[nodiscard]] QSize sizeHint() const override { return {260, 140}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void setUpPlot();
    void setColours();
    void showCurves();
    [[nodiscard]] QString title() const;

    std::vector<response::Sample> m_before;
    std::vector<response::Sample> m_after;
    UtcTime m_beforeTime{};
    UtcTime m_afterTime{};
    Quantity m_quantity = Quantity::Error;
    double m_highest = 1.0;
    std::unique_ptr<QwtPlotGrid> m_grid;
    std::unique_ptr<ResponseItem> m_beforeCurve;
    std::unique_ptr<ResponseItem> m_afterCurve;
    QwtPlot* m_plot;
};

}  // namespace boresight::ui
