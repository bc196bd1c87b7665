// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/station_status.h"
#include "ui/dead_man.h"

#include <QWidget>

#include <map>

// Two buttons that turn one axis slowly back and forth while they are held: to unwind a cable by eye when nobody knows
// which turn it is on. The same dead-man as the jog pad's.
namespace boresight::ui {

class JogButton;
class RequestDesk;
class ValueLabel;

class UnwindButtons : public QWidget
{
    Q_OBJECT

public:
    UnwindButtons(RequestDesk& desk, ValueLabel& notice, AngularRate rate, QWidget* parent = nullptr);

    void setAxis(Axis axis);
    void showStatus(const StationStatus& status);

private:
    void addButton(JogDirection direction, const QString& text, const QString& help);
    void send(const AxisRates& rates);
    void letGoAll();

    RequestDesk& m_desk;
    ValueLabel& m_notice;
    std::map<JogDirection, JogButton*> m_buttons;
    DeadMan m_deadMan;
};

}  // namespace boresight::ui
