// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/limits/region_table_model.h"

#include "ui/kit/theme.h"

namespace boresight::ui {

RegionTableModel::RegionTableModel(ProfileDraft& draft, const QStringList& headings, QObject* parent)
    : TableModel(headings, parent), m_draft(draft)
{
    connect(&m_draft, &ProfileDraft::changed, this, &RegionTableModel::followDraft);
}

void RegionTableModel::followDraft()
{
    const std::size_t now = rowsOfDraft();
    if (now > m_rows) {
        beginInsertRows({}, rowCount(), static_cast<int>(now) - 1);
        m_rows = now;
        endInsertRows();
    } else if (now < m_rows) {
        beginRemoveRows({}, static_cast<int>(now), rowCount() - 1);
        m_rows = now;
        endRemoveRows();
    }
    changeCells();
}

Qt::ItemFlags RegionTableModel::flags(const QModelIndex& index) const
{
    return TableModel::flags(index) | Qt::ItemIsEditable;
}

QVariant RegionTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole:
            return text(index.row(), index.column());
        case Qt::ToolTipRole: {
            const QString problem = m_draft.problem(key(index.row()));
            return problem.isEmpty() ? text(index.row(), index.column()) : problem;  // a long name has no room
        }
        case Qt::ForegroundRole:
            return m_draft.problem(key(index.row())).isEmpty() ? QVariant() : QBrush(currentTheme().warning);
        default:
            return {};
    }
}

bool RegionTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || !index.isValid() || index.row() >= rowCount()) {
        return false;
    }
    pointing::Region edited = region();
    const Result<> taken = put(edited, index.row(), index.column(), value.toString().trimmed());
    Q_EMIT refused(taken ? QString() : taken.error().text);
    if (taken) {
        m_draft.edit([&edited](profile::Profile& profile) { profile.limits = edited; });
    }
    return taken.has_value();
}

}  // namespace boresight::ui

#include "moc_region_table_model.cpp"
