// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/hold_buttons.h"

// Two buttons that turn one axis slowly back and forth while they are held: to unwind a cable by eye when nobody knows
// which turn it is on.
namespace boresight::ui {

class UnwindButtons : public HoldButtons
{
    Q_OBJECT

public:
    UnwindButtons(RequestDesk& desk, ValueLabel& notice, AngularRate rate, QWidget* parent = nullptr);

    void setAxis(Axis axis);
};

}  // namespace boresight::ui
