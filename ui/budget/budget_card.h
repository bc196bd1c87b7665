// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/budget/error_budget.h"

#include <QDialog>

#include <optional>

class QLabel;
class QTableView;

// The error budget as a list: each part with its error and where the number comes from, and the sum above. Not modal,
// so that STOP stays in reach. Gui thread.
namespace boresight::ui {

class BudgetModel;

class BudgetCard : public QDialog
{
    Q_OBJECT

public:
    explicit BudgetCard(QWidget* parent = nullptr);

    void showBudget(const std::optional<budget::ErrorBudget>& budget);

private:
    BudgetModel* m_parts;
    QLabel* m_sum;
    QTableView* m_table;
};

}  // namespace boresight::ui
