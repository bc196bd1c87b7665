// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/hold/hold_buttons.h"

// Two buttons that turn one axis slowly back and forth while they are pressed, to unwind a cable by eye while its wrap
// is unknown. The rate is the present one of the profile.
namespace boresight::ui {

class UnwindButtons : public HoldButtons
{
    Q_OBJECT

public:
    UnwindButtons(RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void setAxis(Axis axis);

private:
    void showRate(AngularRate rate);

    AngularRate m_rate;
};

}  // namespace boresight::ui
