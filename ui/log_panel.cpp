// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/log_panel.h"

#include "ui/command_button.h"
#include "ui/theme.h"
#include "ui/value_label.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QVBoxLayout>

namespace boresight::ui {

LogPanel::LogPanel(QWidget* parent)
    : QWidget(parent),
      m_model(new LogModel(this)),
      m_filter(new LogFilter(this)),
      m_table(makeTable()),
      m_whole(new ValueLabel(tr("Selected line"), fonts::label(), {}, this))
{
    m_whole->setStretching(true);
    m_whole->setLines(4);  // the longest alarm with its remedy at 1024 × 700
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this, &LogPanel::showWhole);
    showWhole({});
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->addWidget(makeFilterRow());
    column->addWidget(m_table, 1);
    column->addWidget(m_whole);
}

void LogPanel::showWhole(const QModelIndex& current)
{
    if (current.isValid()) {
        m_whole->setValue(m_model->entry(m_filter->mapToSource(current).row()).text);
    } else {
        m_whole->setValue(tr("Click a line to read it whole"), Tone::Secondary);
    }
}

QTableView* LogPanel::makeTable()
{
    m_filter->setSourceModel(m_model);
    auto* const table = new QTableView(this);
    table->setModel(m_filter);
    table->setFont(fonts::label());
    table->setAccessibleName(tr("Log"));
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setTabKeyNavigation(false);  // no focus trap
    table->setShowGrid(false);
    table->setWordWrap(false);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().lineSpacing() + 4);
    const QFontMetrics metrics = table->fontMetrics();
    QHeaderView* const header = table->horizontalHeader();
    header->setFont(fonts::label());
    header->setStretchLastSection(true);
    header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header->setHighlightSections(false);
    header->resizeSection(LogModel::Time, metrics.horizontalAdvance(QStringLiteral("00:00:00")) + 14);
    header->resizeSection(LogModel::From, metrics.horizontalAdvance(QStringLiteral("rotctld 127.0.0.1:00000")) + 14);
    auto* const copyAction = new QAction(tr("Copy"), table);
    copyAction->setShortcut(QKeySequence::Copy);
    copyAction->setShortcutContext(Qt::WidgetShortcut);
    connect(copyAction, &QAction::triggered, this, &LogPanel::copy);
    table->addAction(copyAction);
    table->setContextMenuPolicy(Qt::ActionsContextMenu);
    return table;
}

QWidget* LogPanel::makeFilterRow()
{
    auto* const box = new QWidget(this);
    auto* const row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    auto* const source = new QComboBox(box);
    source->setAccessibleName(tr("Filter by source"));
    source->addItem(tr("All sources"), QVariant::fromValue(int(LogSource::All)));
    source->addItem(tr("Operator"), QVariant::fromValue(int(LogSource::Operator)));
    source->addItem(tr("rotctld clients"), QVariant::fromValue(int(LogSource::Clients)));
    source->addItem(tr("Station"), QVariant::fromValue(int(LogSource::Station)));
    connect(source, &QComboBox::currentIndexChanged, this,
            [this, source] { m_filter->setSource(static_cast<LogSource>(source->currentData().toInt())); });
    auto* const warnings = new QCheckBox(tr("▲ only"), box);
    warnings->setAccessibleName(tr("Warnings and alarms only"));
    warnings->setToolTip(tr("Warnings and alarms only"));
    connect(warnings, &QCheckBox::toggled, m_filter, &LogFilter::setWarningsOnly);
    auto* const text = new QLineEdit(box);
    text->setAccessibleName(tr("Filter by text"));
    text->setPlaceholderText(tr("contains"));
    text->setClearButtonEnabled(true);
    connect(text, &QLineEdit::textChanged, m_filter, &LogFilter::setText);
    auto* const copyButton = new QPushButton(tr("Copy"), box);
    copyButton->setAccessibleName(tr("Copy"));
    copyButton->setToolTip(tr("Copy the selected lines, or all that are shown (Ctrl+C in the list)"));
    connect(copyButton, &QPushButton::clicked, this, &LogPanel::copy);
    for (QWidget* const control : {static_cast<QWidget*>(source), static_cast<QWidget*>(warnings),
                                   static_cast<QWidget*>(text), static_cast<QWidget*>(copyButton)}) {
        control->setFont(fonts::label());
        control->setMinimumHeight(kTouchSize);
        row->addWidget(control, control == text ? 1 : 0);
    }
    return box;
}

void LogPanel::append(const std::vector<LogEntry>& entries)
{
    const QScrollBar* const bar = m_table->verticalScrollBar();
    const bool following = bar->value() == bar->maximum();
    m_model->append(entries);
    if (following && !entries.empty()) {
        m_table->scrollToBottom();
    }
}

void LogPanel::copy() const
{
    QModelIndexList rows = m_table->selectionModel()->selectedRows();
    if (rows.isEmpty()) {
        for (int row = 0; row < m_filter->rowCount(); ++row) {
            rows << m_filter->index(row, 0);
        }
    }
    std::sort(rows.begin(), rows.end());
    QString text;
    for (const QModelIndex& index : rows) {
        text += logLine(m_model->entry(m_filter->mapToSource(index).row())) + QLatin1Char('\n');
    }
    QApplication::clipboard()->setText(text);
}

}  // namespace boresight::ui
