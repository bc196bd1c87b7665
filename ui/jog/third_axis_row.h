// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QTimer>
#include <QWidget>

class QLabel;

// The axis beside the two, such as the polarisation: what its drive reports, and two buttons that turn the axis while
// one of them is pressed. They use a dead-man switch: releasing, losing the window and any refusal end the motion, and
// if this program hangs, the station stops the axis. Hidden if the mount has no such axis. Gui thread.
namespace boresight::ui {

class JogButton;
class RequestDesk;
class ValueLabel;

class ThirdAxisRow : public QWidget
{
    Q_OBJECT

public:
    ThirdAxisRow(RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

    [[nodiscard]] JogButton& lower() { return *m_lower; }
    [[nodiscard]] JogButton& upper() { return *m_upper; }

private:
    void build();
    void connectButton(JogButton* button, double sign);
    void send(double sign);
    void letGoAll();
    void showReport(const ThirdAxisStatus& axis);

    RequestDesk& m_desk;
    ValueLabel& m_notice;
    QLabel* m_name;
    ValueLabel* m_place;
    ValueLabel* m_report;
    JogButton* m_lower;
    JogButton* m_upper;
    double m_sign = 0.0;  // of the pressed button
    AngularRate m_rate;
    QTimer m_repeat{this};
};

}  // namespace boresight::ui
