// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/history_model.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"

namespace boresight::ui {

namespace {

QString cell(const CalibrationHistoryEntry& entry, int column)
{
    switch (column) {
        case HistoryModel::When:
            return (entry.inForce ? QStringLiteral("● ") : QStringLiteral("○ ")) + minuteText(entry.when);
        case HistoryModel::Title:
            return entry.superseded ? HistoryModel::tr("%1 (undone)").arg(entry.title) : entry.title;
        default:
            return (entry.otherMount ? QStringLiteral("▲ ") : QString()) + entry.place;
    }
}

}  // namespace

HistoryModel::HistoryModel(QObject* parent) : TableModel({tr("Applied"), tr("What"), tr("Place")}, parent) {}

void HistoryModel::show(const std::vector<CalibrationHistoryEntry>& entries)
{
    beginResetModel();
    m_entries = entries;
    endResetModel();
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

}  // namespace boresight::ui

#include "moc_history_model.cpp"
