// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/table_model.h"

#include <QSortFilterProxyModel>

#include <deque>
#include <optional>

// The station's log as a table (time, source, text) in the order of arrival, with a limited length, and the filter for
// it. The numbers of the lines are not used, because they start again with every station. Gui thread.
namespace boresight::ui {

class LogModel : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Time,
        From,
        Text
    };

    explicit LogModel(QObject* parent = nullptr);

    void append(const std::vector<LogEntry>& entries);
    [[nodiscard]] const LogEntry& entry(int row) const { return m_entries[static_cast<std::size_t>(row)]; }

    // The row of the line that came with this alarm. Empty if it is not in the table.
    [[nodiscard]] std::optional<int> lineOf(const Alarm& alarm) const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_entries.size(); }

private:
    void dropEldest();
    std::deque<LogEntry> m_entries;
};

enum class LogSource
{
    All,
    Operator,
    Clients,  // rotctld
    Station   // the station itself, bus and drives
};

class LogFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setKind(LogKind kind);  // shows only these
    void setSource(LogSource source);
    void setWarningsOnly(bool on);
    void setText(const QString& text);  // matches source or text, ignoring case

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    std::optional<LogKind> m_kind;
    LogSource m_source = LogSource::All;
    bool m_warningsOnly = false;
    QString m_text;
};

[[nodiscard]] LogSource sourceOf(const LogEntry& entry);
[[nodiscard]] QString shortSource(const LogEntry& entry);  // a client by its port: "rotctld :51234"
[[nodiscard]] QString logLine(const LogEntry& entry);      // with date, for the clipboard and for a file

}  // namespace boresight::ui
