// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/lines_view.h"

#include "ui/kit/command_button.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/push_button.h"
#include "ui/kit/text_file.h"
#include "ui/kit/theme.h"
#include "ui/kit/value_label.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

namespace {
constexpr int kReadingLines = 5;  // an alarm with its remedy at 1024 × 700; longer texts scroll
constexpr int kLeastRows = 3;
}  // namespace

LinesView::LinesView(const QString& name, const QString& fileName, QAbstractItemModel& lines, QWidget* parent)
    : QWidget(parent),
      m_lines(lines),
      m_controls(new QHBoxLayout),
      m_table(new QTableView(this)),
      m_whole(new QPlainTextEdit(this)),
      m_notice(new ValueLabel(tr("Outcome"), fonts::label(), {}, this))
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(m_controls);
    column->addWidget(m_table, 1);
    column->addWidget(m_whole);
    column->addWidget(m_notice);
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    m_table->setAccessibleName(name);
    buildTable();
    buildReading();
    addButtons(fileName);
}

void LinesView::buildTable()
{
    m_table->setModel(&m_lines);
    m_table->setFont(fonts::label());
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);  // so that the Tab key can leave the table
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(kRowHeight);
    QHeaderView* const header = m_table->horizontalHeader();
    header->setFont(fonts::label());
    header->setStretchLastSection(true);
    header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header->setHighlightSections(false);
    // The list takes the room that is left. Its usual size would make the page of the log scroll.
    m_table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    m_table->setMinimumHeight(header->sizeHint().height() + kLeastRows * kRowHeight + 2 * m_table->frameWidth());
    addCopyKey();
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this, &LinesView::showWhole);
    connect(&m_lines, &QAbstractItemModel::dataChanged, this, &LinesView::showWhole);
}

void LinesView::addCopyKey()
{
    auto* const action = new QAction(tr("Copy"), m_table);
    action->setShortcut(QKeySequence::Copy);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, &LinesView::copy);
    m_table->addAction(action);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void LinesView::buildReading()
{
    m_whole->setReadOnly(true);
    m_whole->setFont(fonts::label());
    m_whole->setTabChangesFocus(true);
    m_whole->setAccessibleName(tr("Selected line"));
    m_whole->setPlaceholderText(tr("Select a line to read all of it"));
    const int margins = m_whole->height() - m_whole->viewport()->height();
    m_whole->setFixedHeight(kReadingLines * m_whole->fontMetrics().lineSpacing() + margins +
                            2 * static_cast<int>(m_whole->document()->documentMargin()));
}

void LinesView::addButtons(const QString& fileName)
{
    const auto add = [this](const QString& text, const QString& help) {
        QPushButton* const button = makePushButton({.text = text, .help = help}, this);
        const int room = button->fontMetrics().horizontalAdvance(text) + 2 * button->fontMetrics().averageCharWidth();
        button->setFixedWidth(std::max(kTouchSize, room));
        m_controls->addWidget(button);
        return button;
    };
    connect(add(tr("Copy"), tr("Copy the selected lines, or all lines (Ctrl+C in the list)")), &QPushButton::clicked,
            this, &LinesView::copy);
    connect(add(tr("File …"), tr("Save all lines of the list to a text file")), &QPushButton::clicked, this,
            [this, fileName] { askForName(fileName); });
}

void LinesView::addControl(QWidget& control, int stretch)
{
    control.setFont(fonts::label());
    control.setMinimumHeight(kTouchSize);
    m_controls->insertWidget(m_controls->count() - 2, &control, stretch);
}

void LinesView::setColumnRoom(int column, const QString& widest)
{
    m_table->horizontalHeader()->resizeSection(column, m_table->fontMetrics().horizontalAdvance(widest) + 14);
}

// A hidden list has no scroll range yet. It scrolls to its end when the range is known, not when the line arrives.
void LinesView::setFollowing()
{
    QScrollBar* const bar = m_table->verticalScrollBar();
    connect(bar, &QScrollBar::rangeChanged, this, [this, bar](int, int end) {
        if (m_atEnd) {
            bar->setValue(end);
        }
    });
    connect(bar, &QScrollBar::valueChanged, this, [this, bar](int value) { m_atEnd = value == bar->maximum(); });
}

void LinesView::select(int row)
{
    // Not selectRow(), which would extend the selection while Ctrl or Shift is pressed.
    m_table->selectionModel()->setCurrentIndex(m_lines.index(row, 0),
                                               QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

QModelIndex LinesView::current() const
{
    return m_table->currentIndex();
}

void LinesView::showWhole()
{
    const QString text = current().data(WholeTextRole).toString();
    if (text != m_whole->toPlainText()) {
        m_whole->setPlainText(text);
    }
    Q_EMIT currentChanged();
}

QModelIndexList LinesView::allRows() const
{
    QModelIndexList rows;
    for (int row = 0; row < m_lines.rowCount(); ++row) {
        rows << m_lines.index(row, 0);
    }
    return rows;
}

QString LinesView::text(QModelIndexList rows) const
{
    std::sort(rows.begin(), rows.end());
    QString text;
    for (const QModelIndex& row : rows) {
        text += row.data(FileLineRole).toString() + QLatin1Char('\n');
    }
    return text;
}

void LinesView::copy() const
{
    const QModelIndexList selected = m_table->selectionModel()->selectedRows();
    QApplication::clipboard()->setText(text(selected.isEmpty() ? allRows() : selected));
}

void LinesView::askForName(const QString& proposed)
{
    QFileDialog* const dialog =
        askForFile(*this, tr("Save the lines"), QFileDialog::AcceptSave, {tr("Text (*.txt)"), tr("All files (*)")});
    dialog->selectFile(proposed);
    connect(dialog, &QFileDialog::fileSelected, this, &LinesView::save);
}

void LinesView::save(const QString& path)
{
    if (const Result<> saved = saveText(path, text(allRows())); saved) {
        m_notice->setValue(tr("Lines written: %1").arg(m_lines.rowCount()), Tone::Secondary);
    } else {
        m_notice->setValue(tr("Not written: %1").arg(saved.error().text), Tone::Warning, Symbol::Warning);
    }
}

}  // namespace boresight::ui

#include "moc_lines_view.cpp"
