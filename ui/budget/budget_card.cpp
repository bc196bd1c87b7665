// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/budget/budget_card.h"

#include "core/budget/budget_text.h"
#include "ui/budget/budget_model.h"
#include "ui/kit/caption.h"
#include "ui/kit/read_table.h"
#include "ui/kit/theme.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

namespace boresight::ui {

namespace {

constexpr QSize kCardSize{680, 400};  // px, fits beside STOP in a window of 1024×700

}  // namespace

BudgetCard::BudgetCard(QWidget* parent)
    : QDialog(parent),
      m_parts(new BudgetModel(this)),
      m_sum(makeCaption({}, this)),
      m_table(makeReadTable(tr("Parts of the pointing error"), *m_parts, this))
{
    setWindowTitle(tr("Error budget"));
    QFont bold = fonts::text();
    bold.setBold(true);
    m_sum->setFont(bold);
    m_sum->setWordWrap(true);
    m_sum->setAccessibleName(tr("Sum of the error budget"));
    m_table->setWordWrap(true);
    m_table->horizontalHeader()->setSectionResizeMode(BudgetModel::Basis, QHeaderView::Stretch);
    m_table->verticalHeader()->setMinimumSectionSize(kRowHeight);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    auto* const notes =
        makeCaption(tr("Independent parts are added as squares. An unknown part is not in the sum."), this);
    notes->setWordWrap(true);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* const column = new QVBoxLayout(this);
    column->addWidget(m_sum);
    column->addWidget(m_table, 1);
    column->addWidget(notes);
    column->addWidget(buttons);
    resize(kCardSize);
    m_table->setFocus();
}

void BudgetCard::showBudget(const std::optional<budget::ErrorBudget>& budget)
{
    m_sum->setText(budget ? budget::offByText(*budget)
                          : tr("There is no error budget: no direction is aimed at, or the position is old."));
    m_parts->show(budget ? budget->lines : std::vector<budget::ErrorLine>());
}

}  // namespace boresight::ui

#include "moc_budget_card.cpp"
