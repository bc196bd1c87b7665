// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/figures_model.h"

#include <algorithm>

namespace boresight::ui {

FiguresModel::FiguresModel(QObject* parent) : TableModel({tr("Figure"), tr("Before"), tr("After")}, parent) {}

std::vector<FiguresModel::Row> FiguresModel::rowsOf(const BeforeAndAfter& results)
{
    std::vector<Row> rows;
    const auto add = [&rows](const TuningResult* result, QString Row::*column) {
        if (result == nullptr) {
            return;
        }
        for (const Figure& one : figuresOf(*result)) {
            auto row = std::ranges::find(rows, one.name, &Row::name);
            if (row == rows.end()) {
                row = rows.insert(row, Row{.name = one.name});
            }
            (*row).*column = one.value;
        }
    };
    add(results.before, &Row::before);
    add(results.after, &Row::after);
    return rows;
}

void FiguresModel::show(const BeforeAndAfter& results)
{
    std::vector<Row> rows = rowsOf(results);
    if (rows == m_rows) {
        return;
    }
    if (std::ranges::equal(rows, m_rows, {}, &Row::name, &Row::name)) {
        m_rows = std::move(rows);
        changeCells();
        return;
    }
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

QVariant FiguresModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || static_cast<std::size_t>(index.row()) >= m_rows.size()) {
        return {};
    }
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole) {
        const QString& value = index.column() == Before ? row.before : row.after;
        return index.column() == Name ? row.name : value.isEmpty() ? QStringLiteral("---") : value;
    }
    if (role == Qt::TextAlignmentRole && index.column() != Name) {
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    }
    return {};
}

}  // namespace boresight::ui

#include "moc_figures_model.cpp"
