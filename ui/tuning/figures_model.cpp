// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/figures_model.h"

#include <algorithm>

namespace boresight::ui {

FiguresModel::FiguresModel(QObject* parent) : TableModel({tr("Figure"), tr("Before"), tr("After")}, parent) {}

void FiguresModel::show(const BeforeAndAfter& results)
{
    const auto before = results.before != nullptr ? figuresOf(*results.before) : std::vector<Figure>{};
    const auto after = results.after != nullptr ? figuresOf(*results.after) : std::vector<Figure>{};
    std::vector<Row> rows;
    for (std::size_t i = 0; i < std::max(before.size(), after.size()); ++i) {
        rows.push_back({.name = i < before.size() ? before[i].name : after[i].name,
                        .before = i < before.size() ? before[i].value : QString(),
                        .after = i < after.size() ? after[i].value : QString()});
    }
    if (rows == m_rows) {
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
