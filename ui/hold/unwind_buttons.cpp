// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/hold/unwind_buttons.h"

#include "ui/hold/jog_button.h"
#include "ui/kit/format.h"

namespace boresight::ui {

UnwindButtons::UnwindButtons(RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : HoldButtons(desk, notice, tr("Slow jog"), parent)
{
    addButton(JogDirection::Left, tr("Slow jog ↺\n(hold)"), {});
    addButton(JogDirection::Right, tr("Slow jog ↻\n(hold)"), {});
    addButton(JogDirection::Down, tr("Lower ↓\n(hold)"), {});
    addButton(JogDirection::Up, tr("Raise ↑\n(hold)"), {});
    showRate(profile::Profile().jog.unwind);
    setAxis(Axis::Azimuth);
}

void UnwindButtons::showStatus(const StationStatus& status)
{
    if (status.profile && status.profile->jog.unwind != m_rate) {
        showRate(status.profile->jog.unwind);
    }
    HoldButtons::showStatus(status);
}

void UnwindButtons::showRate(AngularRate rate)
{
    m_rate = rate;
    setRate(rate);
    button(JogDirection::Left).setHelp(tr("Turn counter-clockwise at %1 while held").arg(rateText(rate)));
    button(JogDirection::Right).setHelp(tr("Turn clockwise at %1 while held").arg(rateText(rate)));
    button(JogDirection::Down).setHelp(tr("Lower at %1 while held").arg(rateText(rate)));
    button(JogDirection::Up).setHelp(tr("Raise at %1 while held").arg(rateText(rate)));
}

void UnwindButtons::setAxis(Axis axis)
{
    for (const auto& [direction, button] : buttons()) {
        const bool turns = direction == JogDirection::Left || direction == JogDirection::Right;
        button->setVisible(turns == (axis == Axis::Azimuth));
    }
}

}  // namespace boresight::ui

#include "moc_unwind_buttons.cpp"
