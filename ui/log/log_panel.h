// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QStackedWidget;

// The events in three views: the alarms, who moved the mount and why, and every event. The button of the alarms always
// shows how many wait for an acknowledgement.
namespace boresight::ui {

class AlarmsPage;
class ChoiceButton;
class LogModel;
class LogPage;
class RequestDesk;

class LogPanel : public QWidget
{
    Q_OBJECT

public:
    LogPanel(RequestDesk& desk, bool sound, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void append(const std::vector<LogEntry>& entries);
    // Shows the line that came with it. An alarm without a line is shown in the list of alarms.
    void showAlarm(const Alarm& alarm);
    void showAlarms();

    [[nodiscard]] const LogPage& events() const { return *m_events; }
    [[nodiscard]] const LogPage& motions() const { return *m_motions; }

Q_SIGNALS:
    void beepWanted();  // a new alarm should be heard
    void soundChanged(bool on);
    void diagnosticsWanted();

private:
    void addDiagnosticsButton();
    ChoiceButton* addPage(QWidget& page, const QString& text, const QString& help);

    LogModel* m_model;
    LogPage* m_events;
    LogPage* m_motions;
    AlarmsPage* m_alarms;
    QHBoxLayout* m_choice;
    QStackedWidget* m_pages;
    QLabel* m_timing;
    ChoiceButton* m_alarmsChoice;
    ChoiceButton* m_eventsChoice = nullptr;
};

}  // namespace boresight::ui
