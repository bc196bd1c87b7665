// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/pass_planner.h"
#include "ui/sky/planned_beam.h"

#include <QWidget>

#include <optional>

class QTableView;

// The plan of one pass, before it is driven: its variants, one of them selected, and the selected one over time. The
// plan is computed on another thread. Without a plan the reason is shown. Gui thread.
namespace boresight::ui {

class PlanChart;
class VariantTable;

class PlanView : public QWidget
{
    Q_OBJECT

public:
    explicit PlanView(QWidget* parent = nullptr);

    // Empty: no pass is selected. The same question is not computed again. The selected variant stays selected while
    // the pass is the same, if the new plan has it.
    void ask(const std::optional<PlanQuestion>& question);
    void setDriven(const plan::SharedVariant& variant);  // by the mount, of this pass; null: none
    void setNow(UtcTime now);

    // What is selected. Null or empty: no plan, or not yet.
    [[nodiscard]] const plan::SharedVariant& variant() const { return m_variant; }
    // Null also for the variant in use, which the sky shows by itself.
    [[nodiscard]] PlannedBeam beam() const { return m_isInUse ? nullptr : m_beam; }
    [[nodiscard]] QString sentence() const;  // about the plan, or why there is none

    // A window that is even lower squeezes table and picture. The other views of a pass need no more.
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 80}; }

Q_SIGNALS:
    void changed();  // the selected variant, or the sentence

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showAnswer(const SharedAnswer& answer);
    void showDriven();
    void selectRow();
    void showVariant(int row);
    void fitRows();
    void fitColumns();

    PassPlanner* m_planner;
    VariantTable* m_variants;
    QTableView* m_table;
    PlanChart* m_chart;
    std::optional<PlanQuestion> m_question;
    SharedAnswer m_answer;
    std::optional<plan::ChosenWay> m_choice;  // of the operator; empty: the best one, or the one in use
    plan::SharedVariant m_driven;
    plan::SharedVariant m_variant;
    PlannedBeam m_beam;
    bool m_isInUse = false;  // the mount drives the selected variant
};

}  // namespace boresight::ui
