// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/hold/dead_man.h"

#include <QWidget>

#include <map>

// A row of buttons that move the mount while they are pressed, for pages without a jog pad. They use the same dead-man
// switch: releasing, losing the focus or the window, and any refusal end the motion.
namespace boresight::ui {

class JogButton;
class RequestDesk;
class ValueLabel;

class HoldButtons : public QWidget
{
    Q_OBJECT

public:
    // `what` starts the text of a refusal: "Unwind". Nothing moves before setRate().
    HoldButtons(RequestDesk& desk, ValueLabel& notice, const QString& what, QWidget* parent = nullptr);

    // Adds both directions of an axis, which also have keys.
    void addAxis(Axis axis, const QString& lowerHelp, const QString& upperHelp);
    JogButton& addButton(JogDirection direction, const QString& text, const QString& help);
    void setKeyHeld(bool on);  // for all buttons
    void setRate(AngularRate rate) { m_deadMan.setRate(rate); }
    void showStatus(const StationStatus& status);

    [[nodiscard]] JogButton& button(JogDirection direction) { return *m_buttons.at(direction); }

protected:
    [[nodiscard]] const std::map<JogDirection, JogButton*>& buttons() const { return m_buttons; }

private:
    void send(const AxisRates& rates);
    void letGoAll();

    RequestDesk& m_desk;
    ValueLabel& m_notice;
    QString m_what;
    std::map<JogDirection, JogButton*> m_buttons;
    DeadMan m_deadMan{this};
};

}  // namespace boresight::ui
