// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/plan_view.h"

#include "ui/kit/read_table.h"
#include "ui/plan/plan_chart.h"
#include "ui/plan/variant_table.h"
#include "ui/plan/variant_words.h"

#include <QHeaderView>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <utility>

namespace boresight::ui {

namespace {

constexpr int kMostRows = 4;  // without scrolling
constexpr int kRowsIfLow = 2;
constexpr std::chrono::minutes kSameSet{2};  // a new search finds the same pass with slightly different times
constexpr int kRoomForRows = 300;            // px: below this height the chart needs the room

}  // namespace

PlanView::PlanView(QWidget* parent)
    : QWidget(parent),
      m_planner(new PassPlanner(this)),
      m_variants(new VariantTable(this)),
      m_table(makeReadTable(tr("Ways to track the pass"), *m_variants, this)),
      m_chart(new PlanChart(this))
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(m_table);
    column->addWidget(m_chart, 1);
    m_table->hide();
    m_chart->show(nullptr, {}, {}, sentence());
    connect(m_planner, &PassPlanner::planned, this, &PlanView::showAnswer);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& now) {
        if (now.isValid()) {
            m_choice = plan::choiceFor(m_variants->variant(now.row()));
            showVariant(now.row());
            Q_EMIT changed();
        }
    });
}

void PlanView::ask(const std::optional<PlanQuestion>& question)
{
    const bool isSame = question && m_question ? isSameQuestion(*question, *m_question) : !question && !m_question;
    if (isSame) {
        return;
    }
    const bool isSamePass = question && m_question && question->target == m_question->target &&
                            std::chrono::abs(question->task.to - m_question->task.to) < kSameSet;
    if (!isSamePass) {
        m_choice.reset();
        showAnswer(nullptr);
    }
    m_question = question;
    if (m_question) {
        m_planner->plan(*m_question);
    } else {
        m_planner->drop();
    }
    if (!m_answer) {
        m_chart->show(nullptr, {}, {}, sentence());
    }
    Q_EMIT changed();
}

QString PlanView::sentence() const
{
    if (m_answer) {
        return planSentence(*m_answer);
    }
    return m_question ? tr("Planning…") : tr("Select a pass first.");
}

void PlanView::showAnswer(const SharedAnswer& answer)
{
    m_answer = answer;
    m_variant.reset();
    m_beam.reset();
    const std::optional<plan::ChosenWay> choice = m_choice;  // the selection changes with the rows
    m_variants->show(answer);
    m_choice = choice;
    fitRows();
    fitColumns();
    showDriven();
    if (m_variants->rowCount() > 0) {
        selectRow();
        m_choice = choice;
    } else {
        m_chart->show(nullptr, {}, {}, sentence());
    }
    Q_EMIT changed();
}

// The variant that the operator selected, else the one in use, else the best one.
void PlanView::selectRow()
{
    std::optional<std::size_t> row;
    if (m_choice) {
        row = plan::indexOf(m_answer->plan, *m_choice);
    }
    if (!row && m_driven) {
        row = plan::indexOf(m_answer->plan, plan::choiceFor(*m_driven));
    }
    m_table->selectRow(static_cast<int>(row.value_or(0)));
}

void PlanView::showVariant(int row)
{
    m_variant = std::make_shared<const plan::PlanVariant>(m_variants->variant(row));
    m_beam = beamOf(*m_variant, m_answer->pointing);
    showDriven();
    m_chart->show(m_variant, m_answer->azimuths, m_answer->plan.bound, {});
}

void PlanView::setDriven(const plan::SharedVariant& variant)
{
    if (variant == m_driven) {
        return;
    }
    m_driven = variant;
    showDriven();
    if (m_answer && m_variants->rowCount() > 0 && !m_choice) {
        selectRow();
        m_choice.reset();
    }
    Q_EMIT changed();
}

void PlanView::showDriven()
{
    const auto row = m_driven && m_answer ? plan::indexOf(m_answer->plan, plan::choiceFor(*m_driven)) : std::nullopt;
    m_variants->setDriven(row ? std::optional(static_cast<int>(*row)) : std::nullopt);
    m_isInUse = row && m_table->currentIndex().row() == static_cast<int>(*row);
}

void PlanView::setNow(UtcTime now)
{
    m_chart->setNow(now);
}

// As high as its rows, so that the chart has the rest. In a low window the rows scroll.
void PlanView::fitRows()
{
    const int rows = m_variants->rowCount();
    const int most = height() < kRoomForRows ? kRowsIfLow : kMostRows;
    m_table->setVisible(rows > 0);
    m_table->setMinimumHeight(m_table->horizontalHeader()->sizeHint().height() + 2 * m_table->frameWidth() +
                              m_table->verticalHeader()->defaultSectionSize());
    m_table->setMaximumHeight(m_table->horizontalHeader()->sizeHint().height() + 2 * m_table->frameWidth() +
                              std::min(rows, most) * m_table->verticalHeader()->defaultSectionSize());
}

// In a narrow window the columns at the right have no room. The picture and the tooltip have them.
void PlanView::fitColumns()
{
    const QHeaderView& head = *m_table->horizontalHeader();
    const QAbstractItemView& cells = *m_table;
    int room = m_table->viewport()->width();
    for (int column = 0; column < m_variants->columnCount(); ++column) {
        m_table->showColumn(column);
        room -= std::max(head.sectionSizeHint(column), cells.sizeHintForColumn(column) + 1);
        m_table->setColumnHidden(column, column > VariantTable::Beyond && room < 0);
    }
}

void PlanView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitRows();
    layout()->activate();
    fitColumns();
}

}  // namespace boresight::ui

#include "moc_plan_view.cpp"
