// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/readings_table.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
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

#include <algorithm>
#include <cmath>

namespace boresight::ui {
namespace {

QString wattsText(double watts, int decimals)
{
    return ReadingsTable::tr("%1 W").arg(toQString(formatFixed(watts, decimals)));
}

// "0.35 Wh, peak 61 W", "120 J, peak 61 W, 3 s not reported".
QString motionText(const MotionEnergy& motion)
{
    constexpr double kJoulesPerWattHour = 3600.0;
    const bool little = std::abs(motion.joules) < 0.1 * kJoulesPerWattHour;
    const QString energy =
        little ? ReadingsTable::tr("%1 J").arg(toQString(formatFixed(motion.joules, 0)))
               : ReadingsTable::tr("%1 Wh").arg(toQString(formatFixed(motion.joules / kJoulesPerWattHour, 2)));
    const QString text = ReadingsTable::tr("%1, peak %2").arg(energy, wattsText(motion.peak, 0));
    return motion.unknown > Seconds{} ? ReadingsTable::tr("%1, %2 s not reported")
                                            .arg(text, toQString(formatFixed(std::max(motion.unknown.count(), 1.0), 0)))
                                      : text;
}

QString energyText(const PowerStatus& power)
{
    const QString now = power.total ? ReadingsTable::tr("Power: %1.").arg(wattsText(*power.total, 1))
                                    : ReadingsTable::tr("Power: not reported.");
    if (power.running) {
        return now + u' ' + ReadingsTable::tr("This motion: %1.").arg(motionText(*power.running));
    }
    return power.last ? now + u' ' + ReadingsTable::tr("Last motion: %1.").arg(motionText(*power.last)) : now;
}

}  // namespace

ReadingsTable::ReadingsTable(QWidget* parent)
    : QWidget(parent),
      m_model(new ReadingsModel(this)),
      m_table(makeTable()),
      m_energy(new ValueLabel(tr("Electrical power and energy"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Outcome"), fonts::label(), {}, this))
{
    build();
}

QTableView* ReadingsTable::makeTable()
{
    QTableView* const table = makeReadTable(tr("Readings of the drives"), *m_model, this);
    // so that all rows fit at 1280 × 800
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().lineSpacing());
    QHeaderView* const header = table->horizontalHeader();
    header->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const auto stretch = [this, header] {
        for (int column = ReadingsModel::Azimuth; column < m_model->columnCount(); ++column) {
            header->setSectionResizeMode(column, QHeaderView::Stretch);
        }
    };
    stretch();
    connect(m_model, &QAbstractItemModel::modelReset, header, stretch);
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
    m_energy->setStretching(true);
    m_energy->setToolTip(
        tr("Electrical power of all drives. Energy and peak power are those of the present or the last motion. "
           "Negative power flows back to the supply."));
    column->addWidget(m_table, 1);
    column->addWidget(m_energy);
    column->addLayout(buttons);
    column->addWidget(m_notice);
    connect(copying, &QPushButton::clicked, this, &ReadingsTable::copy);
    connect(saving, &QPushButton::clicked, this, &ReadingsTable::askForName);
}

void ReadingsTable::showStatus(const StationStatus& status)
{
    m_model->show(status);
    m_energy->setValue(energyText(status.power), Tone::Secondary);
}

void ReadingsTable::copy()
{
    QApplication::clipboard()->setText(m_model->tabbed());
    m_notice->setValue(tr("Readings copied"), Tone::Secondary);
}

// Saves the readings at the time of the press, because they change while the name is typed.
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
