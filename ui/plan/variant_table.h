// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/table_model.h"
#include "ui/plan/pass_planner.h"

#include <optional>

// The variants of a plan, a row each, the best one first. Gui thread.
namespace boresight::ui {

class VariantTable : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Way,
        Error,
        Loss,
        Beyond,
        Start,
        Margin,
        Hidden,
        Apart
    };

    explicit VariantTable(QObject* parent = nullptr);

    void show(const SharedAnswer& answer);          // null: no rows
    void setDriven(const std::optional<int>& row);  // the variant that the mount drives
    [[nodiscard]] const plan::PlanVariant& variant(int row) const
    {
        return m_answer->plan.variants.at(std::size_t(row));
    }

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_answer ? m_answer->plan.variants.size() : 0; }

private:
    [[nodiscard]] QString text(int row, int column) const;
    [[nodiscard]] QString wayText(int row) const;
    [[nodiscard]] QString help(int column) const;

    SharedAnswer m_answer;
    std::optional<int> m_driven;
};

}  // namespace boresight::ui
