// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

// The second row: the worst alarm (what happened, what Boresight did, what to do), how many wait for an
// acknowledgement, and the acts that bring the station back: acknowledge, reset of STOP, re-arm, control back to the
// clients. An alarm not yet acknowledged flashes its symbol at 1 Hz, never its text.
namespace boresight::ui {

class CommandButton;
class RequestDesk;
class ValueLabel;

class AlarmLine : public QWidget
{
    Q_OBJECT

public:
    explicit AlarmLine(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void beat(SteadyTime now, bool flashing);
    // In the place of a refusal, for some seconds: it stands beside what to do about an alarm.
    void sayForAWhile(const QString& what, SteadyTime now);
    void acknowledge();  // F8

    // For refusals of controls that have no line of their own (STOP).
    [[nodiscard]] ValueLabel& notice() { return *m_notice; }

private:
    void build();
    void showWorst(const StationStatus& status);
    void showRecovery(const StationStatus& status);

    ValueLabel* m_what;
    ValueLabel* m_advice;
    ValueLabel* m_notice;
    CommandButton* m_acknowledge;
    CommandButton* m_recover;
    CommandButton* m_authority;
    StationState m_state = StationState::Disconnected;
    Authority m_control = Authority::Clients;
    bool m_flashing = false;
    QString m_said;
    SteadyTime m_saidAt{};
};

}  // namespace boresight::ui
