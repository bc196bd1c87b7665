// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/guide/step_button.h"

#include <QWidget>

#include <algorithm>

// The button of a step in the row of the guide. (The last page also has a line for each step.)
namespace boresight::ui {

inline StepButton& stepButtonOf(const QWidget& window, GuideStep step)
{
    QList<StepButton*> row = window.findChildren<StepButton*>();
    row.erase(std::remove_if(row.begin(), row.end(), [](const StepButton* one) { return !one->isCheckable(); }),
              row.end());
    return *row.at(static_cast<int>(step));
}

}  // namespace boresight::ui
