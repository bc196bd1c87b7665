// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/budget/budget_model.h"

#include "core/budget/budget_text.h"
#include "ui/kit/theme.h"

namespace boresight::ui {

namespace {

QString budgetCell(const budget::ErrorLine& line, int column)
{
    switch (column) {
        case BudgetModel::Part:
            return budget::nameOf(line.part);
        case BudgetModel::Error:
            return budget::errorText(line);
        default:
            return line.basis;
    }
}

}  // namespace

BudgetModel::BudgetModel(QObject* parent) : TableModel({tr("Part"), tr("Error"), tr("From")}, parent) {}

// The same parts keep their rows, so that the keyboard and a screen reader stay where they are.
void BudgetModel::show(const std::vector<budget::ErrorLine>& lines)
{
    if (lines.size() == m_lines.size()) {
        m_lines = lines;
        changeCells();
        return;
    }
    beginResetModel();
    m_lines = lines;
    endResetModel();
}

QVariant BudgetModel::data(const QModelIndex& index, int role) const
{
    const budget::ErrorLine& line = m_lines[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
            return budgetCell(line, index.column());
        case Qt::AccessibleTextRole:
            return QStringLiteral("%1: %2").arg(budget::nameOf(line.part), budgetCell(line, index.column()));
        case Qt::ForegroundRole:
            return line.error ? QVariant() : QVariant(currentTheme().secondary);
        default:
            return {};
    }
}

}  // namespace boresight::ui

#include "moc_budget_model.cpp"
