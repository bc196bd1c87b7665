// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QTableView;

// The schedule of passes: whether it is armed, the night as a table, and the watched satellites. Gui thread.
namespace boresight::ui {

class CommandButton;
class ProfileDraft;
class RequestDesk;
class ScheduleTable;
class ValueLabel;
class WatchEditor;

class SchedulePage : public QWidget
{
    Q_OBJECT

public:
    SchedulePage(ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    void armOrDisarm();
    void showRehearsal(const StationStatus& status);

    ScheduleTable* m_night;
    QTableView* m_table;
    ValueLabel* m_state;
    ValueLabel* m_refused;
    ValueLabel* m_rehearsed;
    CommandButton* m_arm;
    CommandButton* m_rehearse;
    WatchEditor* m_watched;
    bool m_isArmed = false;
    bool m_isRehearsing = false;
};

}  // namespace boresight::ui
