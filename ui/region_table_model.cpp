// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/region_table_model.h"

#include "ui/theme.h"

namespace boresight::ui {

RegionTableModel::RegionTableModel(ProfileDraft& draft, const QStringList& headers, QObject* parent)
    : QAbstractTableModel(parent), m_draft(draft), m_headers(headers)
{
    connect(&m_draft, &ProfileDraft::changed, this, &RegionTableModel::followDraft);
}

void RegionTableModel::followDraft()
{
    const int now = rows();
    if (now > m_rows) {
        beginInsertRows({}, m_rows, now - 1);
        m_rows = now;
        endInsertRows();
    } else if (now < m_rows) {
        beginRemoveRows({}, now, m_rows - 1);
        m_rows = now;
        endRemoveRows();
    }
    if (m_rows > 0) {
        Q_EMIT dataChanged(index(0, 0), index(m_rows - 1, columnCount() - 1));
    }
}

int RegionTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int RegionTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_headers.size());
}

QVariant RegionTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    return orientation == Qt::Horizontal && role == Qt::DisplayRole ? QVariant(m_headers.value(section)) : QVariant();
}

Qt::ItemFlags RegionTableModel::flags(const QModelIndex& index) const
{
    return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

QVariant RegionTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= m_rows) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole:
            return text(index.row(), index.column());
        case Qt::ToolTipRole: {
            const QString problem = m_draft.problem(key(index.row()));
            return problem.isEmpty() ? QVariant() : problem;
        }
        case Qt::ForegroundRole:
            return m_draft.problem(key(index.row())).isEmpty() ? QVariant() : QBrush(currentTheme().warning);
        default:
            return {};
    }
}

bool RegionTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || !index.isValid() || index.row() >= m_rows) {
        return false;
    }
    pointing::Region edited = region();
    const Result<> taken = put(edited, index.row(), index.column(), value.toString().trimmed());
    Q_EMIT refused(taken ? QString() : QString::fromStdString(taken.error().text));
    if (taken) {
        m_draft.edit([&edited](profile::Profile& profile) { profile.limits = edited; });
    }
    return taken.has_value();
}

}  // namespace boresight::ui
