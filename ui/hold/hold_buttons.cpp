// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/hold/hold_buttons.h"

#include "ui/hold/jog_button.h"
#include "ui/kit/request_desk.h"
#include "ui/kit/value_label.h"

#include <QHBoxLayout>

namespace boresight::ui {

HoldButtons::HoldButtons(RequestDesk& desk, ValueLabel& notice, const QString& what, QWidget* parent)
    : QWidget(parent), m_desk(desk), m_notice(notice), m_what(what)
{
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    connect(&m_deadMan, &DeadMan::jog, this, &HoldButtons::send);
}

void HoldButtons::addAxis(Axis axis, const QString& lowerHelp, const QString& upperHelp)
{
    if (axis == Axis::Azimuth) {
        addButton(JogDirection::Left, tr("AZ ↺ hold"), lowerHelp);
        addButton(JogDirection::Right, tr("AZ ↻ hold"), upperHelp);
    } else {
        addButton(JogDirection::Down, tr("EL ↓ hold"), lowerHelp);
        addButton(JogDirection::Up, tr("EL ↑ hold"), upperHelp);
    }
    setKeyHeld(true);
}

JogButton& HoldButtons::addButton(JogDirection direction, const QString& text, const QString& help)
{
    auto* const button = new JogButton(text, help, this);
    m_buttons[direction] = button;
    layout()->addWidget(button);
    connect(button, &JogButton::holdBegan, this, [this, direction] {
        m_notice.setValue({});
        m_deadMan.hold(direction);
    });
    connect(button, &JogButton::holdEnded, this, [this, direction] { m_deadMan.letGo(direction); });
    return *button;
}

void HoldButtons::setKeyHeld(bool on)
{
    for (const auto& [direction, button] : m_buttons) {
        button->setKeyHeld(on);
    }
}

void HoldButtons::showStatus(const StationStatus& status)
{
    for (const auto& [direction, button] : m_buttons) {
        button->setBlocked(status.permissions.reason(jogAction(direction)));  // a disabled button releases
    }
}

void HoldButtons::send(const AxisRates& rates)
{
    const bool ends = rates == AxisRates{};
    m_desk.send(request::Jog{rates}, this, [this, ends](const std::optional<Error>& error) {
        if (error && !ends) {
            letGoAll();
            m_notice.setValue(tr("%1: %2").arg(m_what, error->text), Tone::Warning, Symbol::Warning);
        }
    });
}

void HoldButtons::letGoAll()
{
    for (const auto& [direction, button] : m_buttons) {
        button->letGo();
    }
}

}  // namespace boresight::ui

#include "moc_hold_buttons.cpp"
