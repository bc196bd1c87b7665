// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/strip_frame.h"
#include "ui/charts/strip_scale.h"

#include <QWidget>

#include <memory>

class QwtPlot;
class QwtPlotGrid;

// One strip: a caption that is legend and readout in one, and the curves over time below it. Passive: it paints the
// given frame and reports the place of the cursor. Apart from the polar plot the only user of Qwt.
namespace boresight::ui {

class MarksItem;
class TracesItem;
class ValueScaleDraw;

class StripChart : public QWidget
{
    Q_OBJECT

public:
    explicit StripChart(QWidget* parent = nullptr);
    ~StripChart() override;

    void setForm(const StripForm& form);
    void setWindow(std::chrono::seconds window);
    void showFrame(const StripFrame& frame);

    [[nodiscard]] int columns() const;   // pixels of the screen
    [[nodiscard]] QRect canvas() const;  // where the curves are, in this widget
    [[nodiscard]] const StripForm& form() const { return m_form; }
    [[nodiscard]] const StripFrame& frame() const { return m_frame; }
    [[nodiscard]] const StripScale& scale() const { return m_scale; }
    [[nodiscard]] QString caption() const;  // as text: "Position °  commanded 12.30  actual 12.28"
    [[nodiscard]] QPointF pixel(int column, double value) const;  // for the test of the painting

    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 70}; }
    [[nodiscard]] QSize sizeHint() const override { return {300, 90}; }

Q_SIGNALS:
    void cursorMoved(int column);
    void cursorLeft();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void setUpPlot();
    void setColours();
    void fitScale();
    int paintCaption(QPainter* painter, bool words) const;
    void putCursor(double x);

    StripForm m_form;
    StripFrame m_frame;
    StripScale m_scale;
    std::unique_ptr<QwtPlotGrid> m_grid;
    std::unique_ptr<TracesItem> m_traces;
    std::unique_ptr<MarksItem> m_marks;
    QwtPlot* m_plot;
    ValueScaleDraw* m_labels;  // owned by the plot
};

}  // namespace boresight::ui
