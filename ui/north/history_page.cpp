// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/history_page.h"

#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/read_table.h"
#include "ui/kit/value_label.h"
#include "ui/north/calibration_words.h"
#include "ui/north/history_model.h"

#include <QHeaderView>
#include <QPlainTextEdit>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr int kWholeLines = 4;

QString wholeText(const CalibrationHistoryEntry& entry)
{
    QStringList lines{HistoryPage::tr("%1: %2").arg(minuteText(entry.when), entry.title), entry.change};
    if (entry.superseded) {
        lines << HistoryPage::tr("Undone, and another calibration was applied later. Kept for reading only");
    }
    lines << (entry.otherMount ? HistoryPage::tr("▲ %1: may not be valid here").arg(entry.place) : entry.place);
    return lines.join(QLatin1Char('\n'));
}

Sentence stateOf(const CalibrationStatus& calibration)
{
    if (!calibration.historyProblem.isEmpty()) {
        return {calibration.historyProblem, Tone::Warning, Symbol::Warning};
    }
    const auto inForce = std::ranges::find_if(calibration.history, &CalibrationHistoryEntry::inForce);
    if (inForce == calibration.history.end()) {
        return {calibration.history.empty() ? HistoryPage::tr("No calibration was applied to this mount yet")
                                            : HistoryPage::tr("None of these is in force")};
    }
    return inForce->otherMount
               ? Sentence{HistoryPage::tr("The calibration in force is from other drives or another site. Check it"),
                          Tone::Warning, Symbol::Warning}
               : Sentence{HistoryPage::tr("In force: %1").arg(inForce->title), Tone::Normal};
}

}  // namespace

HistoryPage::HistoryPage(RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_entries(new HistoryModel(this)),
      m_table(makeReadTable(tr("Calibrations that were applied"), *m_entries, this)),
      m_whole(new QPlainTextEdit(this)),
      m_state(new ValueLabel(tr("Calibration in force"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_redo(
          new CommandButton(tr("Redo"), tr("Apply the undone calibration again. Nothing moves"), desk, *m_notice, this))
{
    m_redo->setAccessibleName(tr("Redo the calibration"));
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    m_state->setStretching(true);
    m_state->setLines(2);
    m_whole->setFont(fonts::label());
    m_whole->setReadOnly(true);
    m_whole->setTabChangesFocus(true);
    m_whole->setAccessibleName(tr("The selected calibration"));
    m_whole->setPlaceholderText(tr("Select a line to read it whole"));
    m_whole->setFixedHeight(kWholeLines * m_whole->fontMetrics().lineSpacing() + 12);
    m_table->horizontalHeader()->setSectionResizeMode(HistoryModel::Title,
                                                      QHeaderView::Stretch);  // the column Place is mostly empty
    auto* const row = new QHBoxLayout;
    row->addWidget(m_state, 1);
    row->addWidget(m_redo);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 0);
    column->setSpacing(4);
    column->addLayout(row);
    column->addWidget(m_table, 1);
    column->addWidget(m_whole);
    column->addWidget(m_notice);
    connect(m_redo, &QPushButton::clicked, this, [this] { m_redo->ask(request::RedoCalibration{}); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &HistoryPage::showEntry);
}

void HistoryPage::showStatus(const StationStatus& status)
{
    m_redo->setBlocked(status.permissions.reason(Action::RedoCalibration));
    if (status.calibration == m_shown) {
        return;
    }
    m_shown = status.calibration;
    const CalibrationStatus& calibration = calibrationOf(status);
    const Sentence state = stateOf(calibration);
    m_state->setValue(state.text, state.tone, state.symbol);
    const int row = m_table->currentIndex().row();
    m_entries->show(calibration.history);
    if (row >= 0 && row < m_entries->rowCount()) {
        m_table->selectRow(row);
    }
    showEntry();
}

void HistoryPage::showEntry()
{
    const int row = m_table->currentIndex().row();
    const QString text = row >= 0 ? wholeText(m_entries->entry(row)) : QString();
    if (text != m_whole->toPlainText()) {
        m_whole->setPlainText(text);
    }
}

}  // namespace boresight::ui

#include "moc_history_page.cpp"
