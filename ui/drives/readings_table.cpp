// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/readings_table.h"

#include "ui/drives/readings_model.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/push_button.h"
#include "ui/kit/read_table.h"
#include "ui/kit/text_file.h"
#include "ui/kit/theme.h"
#include "ui/kit/value_label.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QTableView>
#include <QVBoxLayout>

namespace boresight::ui {

ReadingsTable::ReadingsTable(QWidget* parent)
    : QWidget(parent),
      m_model(new ReadingsModel(this)),
      m_table(makeTable()),
      m_notice(new ValueLabel(tr("Outcome"), fonts::label(), {}, this))
{
    build();
}

QTableView* ReadingsTable::makeTable()
{
    QTableView* const table = makeReadTable(tr("Readings of the drives"), *m_model, this);
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().lineSpacing());  // all rows at 1280 × 800
    QHeaderView* const header = table->horizontalHeader();
    header->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (const int column : {ReadingsModel::Azimuth, ReadingsModel::Elevation}) {
        header->setSectionResizeMode(column, QHeaderView::Stretch);
    }
    return table;
}

void ReadingsTable::build()
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(6);
    auto* const buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    QPushButton* const copying =
        makePushButton({.text = tr("Copy"), .help = tr("Copy all readings of this moment, separated by tabs")}, this);
    QPushButton* const saving =
        makePushButton({.text = tr("Save as …"), .help = tr("Save all readings of this moment to a CSV file")}, this);
    for (QPushButton* const button : {copying, saving}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        buttons->addWidget(button);
    }
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    column->addWidget(m_table, 1);
    column->addLayout(buttons);
    column->addWidget(m_notice);
    connect(copying, &QPushButton::clicked, this, &ReadingsTable::copy);
    connect(saving, &QPushButton::clicked, this, &ReadingsTable::askForName);
}

void ReadingsTable::showStatus(const StationStatus& status)
{
    m_model->show(status);
}

void ReadingsTable::copy()
{
    QApplication::clipboard()->setText(m_model->tabbed());
    m_notice->setValue(tr("Readings copied"), Tone::Secondary);
}

// The readings of the moment of the press: they go on changing while the name is typed.
void ReadingsTable::askForName()
{
    QFileDialog* const dialog =
        askForFile(*this, tr("Save the readings"), QFileDialog::AcceptSave, {tr("Table (*.csv)"), tr("All files (*)")});
    dialog->selectFile(QStringLiteral("drive-readings.csv"));
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, readings = m_model->csv()](const QString& path) { save(path, readings); });
}

void ReadingsTable::save(const QString& path, const QString& readings)
{
    if (const Result<> saved = saveText(path, readings); saved) {
        m_notice->setValue(tr("Readings saved"), Tone::Secondary);
    } else {
        m_notice->setValue(tr("Not written: %1").arg(saved.error().text), Tone::Warning, Symbol::Warning);
    }
}

}  // namespace boresight::ui

#include "moc_readings_table.cpp"
