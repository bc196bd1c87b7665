// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/guide/guide_progress.h"

#include <QAbstractButton>

// One step of the guide: number, name, and its state as a shape and a word. In the row above the pages there may be no
// room for the word. Then it is in the tooltip and below the row. On the last page each step has a line of its own.
namespace boresight::ui {

class StepButton : public QAbstractButton
{
    Q_OBJECT

public:
    enum class Form
    {
        OfTheRow,  // the current step is underlined
        Line
    };

    StepButton(GuideStep step, Form form, QWidget* parent);

    void setNumber(int number);  // its number among the steps that are shown
    void showReport(const StepReport& report);
    [[nodiscard]] StepState state() const { return m_report.state; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();
    void paintInRow(QPainter& painter) const;
    void paintLine(QPainter& painter) const;

    GuideStep m_step;
    Form m_form;
    int m_number = 0;
    StepReport m_report;
};

}  // namespace boresight::ui
