// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history_model.h"

#include "ui/format.h"
#include "ui/theme.h"

namespace boresight::ui {

namespace {

QString cell(const CalibrationHistoryEntry& entry, int column)
{
    switch (column) {
        case HistoryModel::When:
            return (entry.inForce ? QStringLiteral("● ") : QStringLiteral("○ ")) + minuteText(entry.when);
        case HistoryModel::Title:
            return entry.title;
        default:
            return (entry.otherMount ? QStringLiteral("▲ ") : QString()) + entry.place;
    }
}

}  // namespace

void HistoryModel::show(const std::vector<CalibrationHistoryEntry>& entries)
{
    beginResetModel();
    m_entries = entries;
    endResetModel();
}

int HistoryModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_entries.size());
}

int HistoryModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const
{
    const CalibrationHistoryEntry& one = entry(index.row());
    switch (role) {
        case Qt::DisplayRole:
            return cell(one, index.column());
        case Qt::ToolTipRole:
            return one.change;
        case Qt::ForegroundRole:
            return one.otherMount && index.column() == Place ? QVariant(currentTheme().warning)
                   : one.inForce                             ? QVariant()
                                                             : QVariant(currentTheme().secondary);
        default:
            return {};
    }
}

QVariant HistoryModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
        case When:
            return tr("Applied");
        case Title:
            return tr("What");
        default:
            return tr("Place");
    }
}

}  // namespace boresight::ui
