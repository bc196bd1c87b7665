// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/guide/guide_progress.h"

#include <QAbstractButton>

// One step of the guide: number, name, and its state by a shape and a word. In the row above the pages the word may
// find no room, and stands in the tooltip and below the row. On the last page there is room for a line.
namespace boresight::ui {

class StepButton : public QAbstractButton
{
    Q_OBJECT

public:
    enum class Form
    {
        OfTheRow,  // the step that is shown is underlined
        Line
    };

    StepButton(GuideStep step, Form form, QWidget* parent);

    void setNumber(int number);  // among those that are shown
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
