// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/scan_box.h"

#include "core/base/numbers.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/guide_fields.h"
#include "ui/kit/value_label.h"
#include "ui/north/calibration_words.h"
#include "ui/north/run_line.h"
#include "ui/north/scan_plot.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QSignalBlocker>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr double kUsualWidth = 2.0;        // in beam widths
constexpr double kScanBoxNarrowest = 0.2;  // degrees, and
constexpr double kWidest = 40.0;           // degrees: the range that the station scans

QString idleText(const CalibrationStatus& calibration, const QString& reason)
{
    if (!reason.isEmpty()) {
        return ScanBox::tr("Not now: %1").arg(reason);
    }
    return calibration.powerLine.name.isEmpty()
               ? ScanBox::tr("The scan goes across, then in elevation. Type the power at each place")
               : ScanBox::tr("The scan goes across, then in elevation. The receiver reports the power");
}

// From both lines: the position of the peak, the width of the beam, and the height of the peak.
QString foundText(const calibration::CrossScan& scan)
{
    const QString place =
        ScanBox::tr("Peak: across %1, elevation %2; beam %3 × %4")
            .arg(offsetText(scan.across.offset), offsetText(scan.elevation.offset),
                 angleText(scan.across.halfPowerWidth, 1), angleText(scan.elevation.halfPowerWidth, 1));
    // The second line went through the peak of the first.
    const auto& background = scan.elevation.background;
    return background ? ScanBox::tr("%1, %2 dB over the background")
                            .arg(place)
                            .arg(scan.elevation.decibels - *background, 0, 'f', 1)
                      : ScanBox::tr("%1. The scan did not reach the background.").arg(place);
}

// The last value of the receiver and its age, or the problem of its line.
Sentence lineSentence(const PowerLineStatus& line)
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
                          : ScanBox::tr("%1: no data yet").arg(line.name),
            Tone::Secondary};
}

}  // namespace

ScanBox::ScanBox(RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : QWidget(parent),
      m_notice(notice),
      m_width(makeField(
          {.name = tr("Width of the scan"),
           .help =
               tr("On the sky, from end to end of each line. The default is twice the beam width. 1.5 to 3 beam widths "
                  "work"),
           .min = kScanBoxNarrowest,
           .max = kWidest,
           .decimals = 1,
           .unit = QStringLiteral("°")},
          this)),
      m_power(new QLineEdit(this)),
      m_run(new RunLine(CalibrationRun::CrossScan, tr("Cross scan"), this)),
      m_line(new ValueLabel(tr("Power of the receiver"), fonts::label(), {}, this)),
      m_found(new ValueLabel(tr("What the scan found"), fonts::label(), {}, this)),
      m_plot(new ScanPlot(this)),
      m_start(new CommandButton(tr("Scan"), {}, desk, notice, this)),
      m_give(new CommandButton(tr("Enter dB"),
                               tr("Enter the power at this place. The mount goes to the next place (Enter)"), desk,
                               notice, this))
{
    m_power->setFont(fonts::label());
    m_power->setAlignment(Qt::AlignRight);
    m_power->setMaxLength(12);
    m_power->setMinimumHeight(kTouchSize);
    m_power->setPlaceholderText(tr("e.g. -73.2"));  // a bare number would look like the last reading
    m_power->setAccessibleName(tr("Received power in dB"));
    build();
    connect(m_width, &QDoubleSpinBox::valueChanged, this, [this] { m_isTyped = true; });
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
    grid->setVerticalSpacing(2);  // so that it fits into 700 px even with the receiver's line
    grid->addWidget(makeCaption(tr("Width"), *m_width), 0, 0);
    grid->addWidget(m_width, 0, 1);
    grid->addWidget(m_start, 0, 2);
    grid->addWidget(m_run, 1, 0, 1, 3);
    grid->addWidget(makeCaption(tr("Power"), *m_power), 2, 0);
    grid->addWidget(m_power, 2, 1);
    grid->addWidget(m_give, 2, 2);
    m_line->setStretching(true);
    m_line->setCollapsing(true);
    grid->addWidget(m_line, 3, 0, 1, 3);
    m_found->setStretching(true);
    m_found->setLines(2);
    grid->addWidget(m_found, 1, 0, 1, 3);  // in place of the text during a run
    m_found->hide();
    grid->addWidget(m_plot, 4, 0, 1, 3);
    m_plot->hide();
    grid->setColumnStretch(1, 1);
}

void ScanBox::offerWidth(const StationStatus& status)
{
    if (!m_isTyped && status.profile) {
        const QSignalBlocker notTyped(m_width);
        m_width->setValue(
            std::clamp(kUsualWidth * status.profile->mount.beamWidth.degrees(), kScanBoxNarrowest, kWidest));
    }
}

void ScanBox::showFound(const CalibrationStatus& calibration)
{
    const bool isFound = calibration.scan && !m_running;
    m_found->setValue(isFound ? foundText(*calibration.scan) : QString());
    m_run->setVisible(!isFound);
    m_found->setVisible(isFound);
    m_plot->setVisible(isFound);
    m_plot->showScan(calibration.scan);
}

void ScanBox::showStatus(const StationStatus& status)
{
    const CalibrationStatus& calibration = calibrationOf(status);
    m_running = calibration.progress.run == CalibrationRun::CrossScan;
    m_body = m_running ? calibration.body.value_or(m_wanted) : m_wanted;
    const QString body = bodyName(m_body);
    const QString reason = m_running ? QString() : status.permissions.reason(actionOf(Action::ScanSun, m_body));
    m_run->showProgress(calibration.progress, idleText(calibration, reason));
    m_start->setCommand(m_running ? tr("End scan") : tr("Scan %1").arg(body),
                        m_running ? tr("End the scan. No point is taken")
                                  : tr("Move the mount across the %1 and take the peak as a point").arg(body));
    m_start->setBlocked(reason);
    m_width->setEnabled(!m_running);
    offerWidth(status);
    showFound(calibration);
    const Sentence line = lineSentence(calibration.powerLine);
    m_line->setValue(line.text, line.tone, line.symbol);
    m_give->setBlocked(status.permissions.reason(Action::GivePower));
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
        m_notice.setValue(tr("Power: Type a number in dB, for example -73.2."), Tone::Warning, Symbol::Warning);
        m_power->setFocus();
        m_power->selectAll();
    }
}

}  // namespace boresight::ui

#include "moc_scan_box.cpp"
