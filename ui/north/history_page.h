// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QPlainTextEdit;
class QTableView;

// Step 5 of finding north: what was applied, when, where and with which drives. Undo and Redo in the bar below move
// through this list.
namespace boresight::ui {

class CommandButton;
class HistoryModel;
class RequestDesk;
class ValueLabel;

class HistoryPage : public QWidget
{
    Q_OBJECT

public:
    explicit HistoryPage(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void showEntry();

    std::shared_ptr<const CalibrationStatus> m_shown;
    HistoryModel* m_entries;
    QTableView* m_table;
    QPlainTextEdit* m_whole;
    ValueLabel* m_state;
    ValueLabel* m_notice;
    CommandButton* m_redo;
};

}  // namespace boresight::ui
