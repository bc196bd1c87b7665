// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/table_model.h"

namespace boresight::ui {

TableModel::TableModel(const QStringList& headings, QObject* parent) : QAbstractTableModel(parent), m_headings(headings)
{}

int TableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows());
}

int TableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_headings.size());
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    return orientation == Qt::Horizontal && role == Qt::DisplayRole ? QVariant(m_headings.value(section)) : QVariant();
}

void TableModel::setHeadings(const QStringList& headings)
{
    if (headings == m_headings) {
        return;
    }
    beginResetModel();
    m_headings = headings;
    endResetModel();
}

void TableModel::changeCells()
{
    if (rowCount() > 0) {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    }
}

}  // namespace boresight::ui

#include "moc_table_model.cpp"
