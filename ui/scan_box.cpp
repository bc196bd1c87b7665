// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scan_box.h"

#include "core/base/numbers.h"
#include "ui/calibration_permission.h"
#include "ui/calibration_words.h"
#include "ui/command_button.h"
#include "ui/format.h"
#include "ui/guide_fields.h"
#include "ui/run_line.h"
#include "ui/value_label.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

namespace boresight::ui {

namespace {

constexpr double kUsualWidth = 6.0;  // degrees: twice the beam of a small dish

QString idleText(const CalibrationStatus& calibration, const QString& reason)
{
    if (!reason.isEmpty()) {
        return ScanBox::tr("Not now: %1").arg(reason);
    }
    return calibration.scan ? ScanBox::tr("Peak at %1, ± %2")
                                  .arg(axisText(calibration.scan->peak), angleText(calibration.scan->sigma))
                            : ScanBox::tr("Scans across, then in elevation; type the power at each place");
}

// What the receiver said last, how long ago, or what is wrong with its line.
Sentence lineSentence(const power::LineStatus& line)
{
    if (!line.problem.isEmpty()) {
        return {line.problem, Tone::Warning, Symbol::Warning};
    }
    if (line.name.isEmpty()) {
        return {};
    }
    return {line.decibels ? ScanBox::tr("%1: %2 dB, %3 s old")
                                .arg(line.name)
                                .arg(*line.decibels, 0, 'f', 1)
                                .arg(line.age.count(), 0, 'f', 0)
                          : ScanBox::tr("%1: nothing has come yet").arg(line.name),
            Tone::Secondary};
}

}  // namespace

ScanBox::ScanBox(RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : QWidget(parent),
      m_notice(notice),
      m_width(makeField({.name = tr("Width of the scan"),
                         .help = tr("On the sky, twice the width of the beam or so"),
                         .min = 0.2,
                         .max = 60.0,
                         .decimals = 1,
                         .unit = QStringLiteral("°")},
                        this)),
      m_power(new QLineEdit(this)),
      m_run(new RunLine(CalibrationRun::CrossScan, tr("Cross scan"), this)),
      m_line(new ValueLabel(tr("Power of the receiver"), fonts::label(), {}, this)),
      m_start(new CommandButton(tr("Scan"), {}, desk, notice, this)),
      m_give(new CommandButton(tr("Give dB"), tr("The power at this place; the mount goes on to the next (Enter)"),
                               desk, notice, this))
{
    m_width->setValue(kUsualWidth);
    m_power->setFont(fonts::label());
    m_power->setAlignment(Qt::AlignRight);
    m_power->setMaxLength(12);
    m_power->setMinimumHeight(kTouchSize);
    m_power->setPlaceholderText(QStringLiteral("-73.2"));
    m_power->setAccessibleName(tr("Received power in dB"));
    build();
    connect(m_start, &QPushButton::clicked, this, &ScanBox::startOrEnd);
    connect(m_give, &QPushButton::clicked, this, &ScanBox::give);
    connect(m_power, &QLineEdit::returnPressed, this, &ScanBox::give);
    connect(m_give, &CommandButton::accepted, m_power, &QLineEdit::clear);
}

void ScanBox::build()
{
    m_width->setMinimumHeight(kTouchSize);
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(2);  // with the receiver's line, too, it fits into 700 px
    QLabel* const width = makeCaption(tr("Width"), this);
    width->setBuddy(m_width);
    QLabel* const power = makeCaption(tr("Power"), this);
    power->setBuddy(m_power);
    grid->addWidget(width, 0, 0);
    grid->addWidget(m_width, 0, 1);
    grid->addWidget(m_start, 0, 2);
    grid->addWidget(m_run, 1, 0, 1, 3);
    grid->addWidget(power, 2, 0);
    grid->addWidget(m_power, 2, 1);
    grid->addWidget(m_give, 2, 2);
    m_line->setStretching(true);
    m_line->setCollapsing(true);
    grid->addWidget(m_line, 3, 0, 1, 3);
    grid->setColumnStretch(1, 1);
}

void ScanBox::showStatus(const StationStatus& status)
{
    const CalibrationStatus& calibration = calibrationOf(status);
    m_running = calibration.progress.run == CalibrationRun::CrossScan;
    m_body = calibration.body.value_or(ephemeris::Body::Sun);
    const QString body = bodyName(m_body);
    const QString reason = m_running ? QString() : whyNoScan(status, m_body);
    m_run->showProgress(calibration.progress, idleText(calibration, reason));
    m_start->setCommand(m_running ? tr("End scan") : tr("Scan %1").arg(body),
                        m_running ? tr("No point is taken")
                                  : tr("The mount moves across the %1 and takes the peak as a point").arg(body));
    m_start->setBlocked(reason);
    m_width->setEnabled(!m_running);
    const Sentence line = lineSentence(calibration.powerLine);
    m_line->setValue(line.text, line.tone, line.symbol);
    m_give->setBlocked(whyNoPower(status));
}

void ScanBox::startOrEnd()
{
    m_start->ask(m_running
                     ? Request(request::EndCalibration{})
                     : Request(request::StartCrossScan{.width = Angle::fromDegrees(m_width->value()), .body = m_body}));
}

void ScanBox::give()
{
    if (!m_give->isEnabled()) {
        m_notice.setValue(m_give->toolTip(), Tone::Warning, Symbol::Warning);
        return;
    }
    if (const auto decibels = parseFinite(m_power->text().trimmed().toStdString())) {
        m_give->ask(request::GivePower{*decibels});
    } else {
        m_notice.setValue(tr("Power: a number of dB is wanted, as -73.2"), Tone::Warning, Symbol::Warning);
        m_power->setFocus();
        m_power->selectAll();
    }
}

}  // namespace boresight::ui
