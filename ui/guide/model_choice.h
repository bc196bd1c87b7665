// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/rotator_models.h"
#include "ui/kit/touch_combo.h"

// Chooses one of many rotator models. Typing shows the models whose number, maker or name contains the typed text.
namespace boresight::ui {

class ModelChoice : public TouchCombo
{
    Q_OBJECT

public:
    explicit ModelChoice(QWidget* parent = nullptr);

    void showModels(const RotatorModels& models);
    void choose(int number);
    // The number of the chosen model. 0: none.
    [[nodiscard]] int number() const;
    [[nodiscard]] QString whyNone() const;
    [[nodiscard]] const QString& problem() const { return m_models.problem; }
    [[nodiscard]] bool isEmpty() const { return m_models.list.empty(); }

private:
    RotatorModels m_models;
};

}  // namespace boresight::ui
