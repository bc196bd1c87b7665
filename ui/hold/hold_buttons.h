// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/hold/dead_man.h"

#include <QWidget>

#include <map>

// A row of buttons that move the mount by hand while they are held, for pages that have no jog pad. The same dead-man
// as the pad's: letting go, losing focus or window, and any refusal end the motion.
namespace boresight::ui {

class JogButton;
class RequestDesk;
class ValueLabel;

class HoldButtons : public QWidget
{
    Q_OBJECT

public:
    // `what` begins the line that says why it was refused: "Unwind". Nothing moves before setRate().
    HoldButtons(RequestDesk& desk, ValueLabel& notice, const QString& what, QWidget* parent = nullptr);

    // Both ways of an axis, by key as well.
    void addAxis(Axis axis, const QString& lowerHelp, const QString& upperHelp);
    JogButton& addButton(JogDirection direction, const QString& text, const QString& help);
    void setKeyHeld(bool on);  // of all buttons
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
