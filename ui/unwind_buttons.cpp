// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/unwind_buttons.h"

#include "ui/format.h"
#include "ui/jog_button.h"
#include "ui/request_desk.h"
#include "ui/value_label.h"

#include <QHBoxLayout>

namespace boresight::ui {

UnwindButtons::UnwindButtons(RequestDesk& desk, ValueLabel& notice, AngularRate rate, QWidget* parent)
    : QWidget(parent), m_desk(desk), m_notice(notice)
{
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    addButton(JogDirection::Left, tr("Unwind ↺\n(hold)"),
              tr("Turn counter-clockwise at %1 while held").arg(rateText(rate)));
    addButton(JogDirection::Right, tr("Unwind ↻\n(hold)"), tr("Turn clockwise at %1 while held").arg(rateText(rate)));
    addButton(JogDirection::Down, tr("Lower ↓\n(hold)"), tr("Lower at %1 while held").arg(rateText(rate)));
    addButton(JogDirection::Up, tr("Raise ↑\n(hold)"), tr("Raise at %1 while held").arg(rateText(rate)));
    m_deadMan.setRate(rate);
    connect(&m_deadMan, &DeadMan::jog, this, &UnwindButtons::send);
    setAxis(Axis::Azimuth);
}

void UnwindButtons::addButton(JogDirection direction, const QString& text, const QString& help)
{
    auto* const button = new JogButton(text, help, this);
    m_buttons[direction] = button;
    layout()->addWidget(button);
    connect(button, &JogButton::holdBegan, this, [this, direction] {
        m_notice.setValue({});
        m_deadMan.hold(direction);
    });
    connect(button, &JogButton::holdEnded, this, [this, direction] { m_deadMan.letGo(direction); });
}

void UnwindButtons::setAxis(Axis axis)
{
    for (const auto& [direction, button] : m_buttons) {
        const bool turns = direction == JogDirection::Left || direction == JogDirection::Right;
        button->setVisible(turns == (axis == Axis::Azimuth));
    }
}

void UnwindButtons::showStatus(const StationStatus& status)
{
    for (const auto& [direction, button] : m_buttons) {
        button->setBlocked(whyNoJog(status, direction));  // a disabled button lets go
    }
}

void UnwindButtons::send(const AxisRates& rates)
{
    const bool ends = rates == AxisRates{};
    m_desk.send(request::Jog{rates}, this, [this, ends](const std::optional<Error>& error) {
        if (error && !ends) {
            letGoAll();
            m_notice.setValue(tr("Unwind: %1").arg(QString::fromStdString(error->text)), Tone::Warning,
                              Symbol::Warning);
        }
    });
}

void UnwindButtons::letGoAll()
{
    for (const auto& [direction, button] : m_buttons) {
        button->letGo();
    }
}

}  // namespace boresight::ui
