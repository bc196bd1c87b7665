// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/guide/guide_progress.h"

#include <QAbstractButton>

// One step of the guide in its row: number, name, and by its shape whether it is done, skipped or open. The step that
// is shown is underlined.
namespace boresight::ui {

class StepButton : public QAbstractButton
{
    Q_OBJECT

public:
    StepButton(GuideStep step, int number, QWidget* parent);

    void setState(StepState state);
    [[nodiscard]] StepState state() const { return m_state; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    GuideStep m_step;
    int m_number;
    StepState m_state = StepState::Open;
};

}  // namespace boresight::ui
