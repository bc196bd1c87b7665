// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/log_model.h"

#include <QWidget>

class QModelIndex;
class QTableView;

// Every command with its source and what became of it, faults and remarks: filter by source, by severity, by text;
// copy the selected lines (or all that are shown); the current line is shown whole below the list. Follows the newest
// line while it is scrolled to the end.
namespace boresight::ui {

class ValueLabel;

class LogPanel : public QWidget
{
    Q_OBJECT

public:
    explicit LogPanel(QWidget* parent = nullptr);

    void append(const std::vector<LogEntry>& entries);

    [[nodiscard]] const LogFilter& shown() const { return *m_filter; }

private:
    QWidget* makeFilterRow();
    QTableView* makeTable();
    void showWhole(const QModelIndex& current);
    void copy() const;

    LogModel* m_model;
    LogFilter* m_filter;
    QTableView* m_table;
    ValueLabel* m_whole;
};

}  // namespace boresight::ui
