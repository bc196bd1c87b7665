// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/terms_box.h"

#include "core/base/text.h"
#include "core/profile/setting.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/guide_fields.h"
#include "ui/kit/text_file.h"
#include "ui/kit/value_label.h"
#include "ui/north/calibration_words.h"

#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <cmath>

namespace boresight::ui {

namespace {

constexpr int kTermsBoxDecimals = 4;  // of a degree; a field without typing keeps all decimals of its value
constexpr double kHalfPlace = 0.5001e-4;
constexpr int kRows = 4;                     // in each of two columns
constexpr qint64 kTermsBoxLargest = 100000;  // bytes: far more than seven lines with comments

std::string keyOf(calibration::Term term)
{
    return "pointing." + std::string(calibration::nameOf(term)) + "_deg";
}

}  // namespace

TermsBox::TermsBox(RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : QWidget(parent),
      m_notice(notice),
      m_propose(new CommandButton(tr("Propose"), tr("Make these terms the proposal for Apply"), desk, notice, this)),
      m_reset(new CommandButton(tr("In force"), tr("Show the terms in force again"), desk, notice, this)),
      m_import(new CommandButton(tr("Import …"), tr("Read terms from a text file. Apply then uses them."), desk, notice,
                                 this)),
      m_export(new CommandButton(tr("Export …"), tr("Write the terms in force to a text file"), desk, notice, this))
{
    m_propose->setAccessibleName(tr("Propose the typed terms"));
    m_reset->setAccessibleName(tr("Terms in force again"));
    m_import->setAccessibleName(tr("Import terms"));
    m_export->setAccessibleName(tr("Export terms"));
    build();
    connect(m_propose, &QPushButton::clicked, this, &TermsBox::propose);
    connect(m_reset, &QPushButton::clicked, this, &TermsBox::showInForce);
    connect(m_import, &QPushButton::clicked, this, &TermsBox::chooseImport);
    connect(m_export, &QPushButton::clicked, this, &TermsBox::chooseExport);
    connect(m_propose, &CommandButton::accepted, this, &TermsBox::proposed);
    connect(m_import, &CommandButton::accepted, this, &TermsBox::proposed);
}

void TermsBox::build()
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(2);  // with 4 px the window would not fit into 700 px
    for (const calibration::Term term : calibration::kAllTerms) {
        addField(term);
        const int place = static_cast<int>(calibration::indexOf(term));
        QLabel* const caption = makeCaption(termName(keyOf(term)), *field(term).box);
        caption->setWordWrap(true);  // the room beside the field is two lines high and too narrow for a long name
        grid->addWidget(caption, place % kRows, 2 * (place / kRows));
        grid->addWidget(field(term).box, place % kRows, 2 * (place / kRows) + 1);
    }
    grid->addLayout(makeButtons(), kRows, 0, 1, 4);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    grid->setRowStretch(kRows + 1, 1);
}

void TermsBox::addField(calibration::Term term)
{
    const profile::Setting& setting = *profile::findSetting(keyOf(term));
    Field& one = field(term);
    one.box = makeField({.name = termName(setting.key),
                         .help = Text::of(setting.text),
                         .min = setting.min,
                         .max = setting.max,
                         .decimals = kTermsBoxDecimals,
                         .unit = QStringLiteral("°")},
                        this);
    connect(one.box, &QDoubleSpinBox::valueChanged, this, [&one] { one.typed = true; });
}

QLayout* TermsBox::makeButtons()
{
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    for (CommandButton* const button : {m_propose, m_reset, m_import, m_export}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(button);
    }
    return row;
}

void TermsBox::showStatus(const StationStatus& status)
{
    const CalibrationStatus& calibration = calibrationOf(status);
    m_sheet = calibration.sheet;
    for (const calibration::Term term : calibration::kAllTerms) {
        Field& one = field(term);
        one.inForce = calibration::valueOf(calibration.present, term);
        if (one.typed && !one.box->hasFocus() && isAsInForce(one)) {
            one.typed = false;  // it was applied, so from now on the field shows the value in effect
        }
        if (!one.typed) {
            const QSignalBlocker silent(one.box);
            one.box->setValue(one.inForce.degrees());
        }
    }
    const QString reason = status.permissions.reason(Action::ProposeTerms);
    m_propose->setBlocked(reason);
    m_import->setBlocked(reason);
    m_export->setBlocked(status.calibration ? QString() : tr("The station has not reported its terms yet."));
}

// Compared with the decimals of the field: a value that looks the same was not changed, and keeps all its decimals.
bool TermsBox::isAsInForce(const Field& one)
{
    return std::abs(one.box->value() - one.inForce.degrees()) <= kHalfPlace;
}

void TermsBox::showInForce()
{
    for (Field& one : m_fields) {
        one.box->setValue(one.inForce.degrees());
        one.typed = false;
    }
}

void TermsBox::propose()
{
    pointing::PointingTerms terms;
    for (const calibration::Term term : calibration::kAllTerms) {
        const Field& one = field(term);
        calibration::valueOf(terms, term) = isAsInForce(one) ? one.inForce : Angle::fromDegrees(one.box->value());
    }
    m_propose->ask(request::ProposeTerms{terms});
}

void TermsBox::chooseImport()
{
    const QFileDialog* const dialog = askForFile(*this, tr("Import the terms of a pointing model"),
                                                 QFileDialog::AcceptOpen, {tr("Terms (*.txt)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &TermsBox::import);
}

void TermsBox::import(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        complain(file.errorString());
        return;
    }
    const QByteArray text = file.read(kTermsBoxLargest + 1);  // its reader refuses a longer text
    m_import->ask(request::ImportTerms{.name = QFileInfo(path).fileName(), .text = text.toStdString()});
}

void TermsBox::chooseExport()
{
    QFileDialog* const dialog =
        askForFile(*this, tr("Export the terms in force"), QFileDialog::AcceptSave, {tr("Terms (*.txt)")});
    dialog->selectFile(QStringLiteral("terms.txt"));
    connect(dialog, &QFileDialog::fileSelected, this, &TermsBox::exportTo);
}

void TermsBox::exportTo(const QString& path)
{
    if (const Result<> written = saveText(path, toQString(calibration::toText(m_sheet))); !written) {
        complain(written.error().text);
        return;
    }
    m_notice.setValue(tr("Written: %1").arg(path));
}

void TermsBox::complain(const QString& reason)
{
    m_notice.setValue(reason, Tone::Warning, Symbol::Warning);
}

}  // namespace boresight::ui

#include "moc_terms_box.cpp"
