// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/unwind_buttons.h"

#include "ui/format.h"
#include "ui/jog_button.h"

namespace boresight::ui {

UnwindButtons::UnwindButtons(RequestDesk& desk, ValueLabel& notice, AngularRate rate, QWidget* parent)
    : HoldButtons(desk, notice, tr("Unwind"), rate, parent)
{
    addButton(JogDirection::Left, tr("Unwind ↺\n(hold)"),
              tr("Turn counter-clockwise at %1 while held").arg(rateText(rate)));
    addButton(JogDirection::Right, tr("Unwind ↻\n(hold)"), tr("Turn clockwise at %1 while held").arg(rateText(rate)));
    addButton(JogDirection::Down, tr("Lower ↓\n(hold)"), tr("Lower at %1 while held").arg(rateText(rate)));
    addButton(JogDirection::Up, tr("Raise ↑\n(hold)"), tr("Raise at %1 while held").arg(rateText(rate)));
    setAxis(Axis::Azimuth);
}

void UnwindButtons::setAxis(Axis axis)
{
    for (const auto& [direction, button] : buttons()) {
        const bool turns = direction == JogDirection::Left || direction == JogDirection::Right;
        button->setVisible(turns == (axis == Axis::Azimuth));
    }
}

}  // namespace boresight::ui
