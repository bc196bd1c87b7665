// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/budget/error_budget.h"
#include "ui/kit/table_model.h"

#include <vector>

// The parts of the pointing error: name, error, where the number comes from. Gui thread.
namespace boresight::ui {

class BudgetModel : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Part,
        Error,
        Basis
    };

    explicit BudgetModel(QObject* parent = nullptr);

    void show(const std::vector<budget::ErrorLine>& lines);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_lines.size(); }

private:
    std::vector<budget::ErrorLine> m_lines;
};

}  // namespace boresight::ui
