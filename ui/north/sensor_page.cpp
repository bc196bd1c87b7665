// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/sensor_page.h"

#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/push_button.h"
#include "ui/kit/read_table.h"
#include "ui/kit/value_label.h"
#include "ui/north/calibration_words.h"
#include "ui/north/compass_dial.h"
#include "ui/north/declination_box.h"
#include "ui/north/run_line.h"
#include "ui/north/sensor_details.h"
#include "ui/north/sensor_levels.h"

#include <QApplication>
#include <QClipboard>
#include <QGridLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableView>

#include <tuple>

namespace boresight::ui {

namespace {

void nameSimulatedSensor(profile::Profile& profile)
{
    profile.sensor.source = profile::SensorSource::Simulated;
}

// The result stays readable although newer settings have come into effect.
QString averageText(const CalibrationStatus& calibration)
{
    if (!calibration.sensorOffset) {
        return {};
    }
    const Angle inForce = calibration.present.azimuthOffset;
    const auto& sigma = calibration.sheet.sigmas[calibration::indexOf(calibration::Term::AzimuthOffset)];
    const QString now = sigma ? offsetText({inForce, *sigma}) : signedAngleText(inForce.wrapped180());
    return SensorPage::tr("Last average: axis %1, in force %2").arg(offsetText(calibration.sensorOffset->offset), now);
}

}  // namespace

SensorPage::SensorPage(RequestDesk& desk, ProfileDraft& draft, QWidget* parent)
    : QWidget(parent),
      m_profileChange(draft, desk),
      m_overview(new QWidget(this)),
      m_details(new SensorDetails(this)),
      m_table(makeReadTable(tr("Details of the sensor"), *m_details, this)),
      m_openDetails(makePushButton(
          {.text = tr("Details"), .name = tr("Show the details"), .help = tr("All that the sensor reports")}, this)),
      m_copy(makePushButton({.text = tr("Copy"), .name = tr("Copy the details"), .help = tr("As text")}, this)),
      m_dial(new CompassDial(this)),
      m_levels(new SensorLevels(this)),
      m_sensor(new ValueLabel(tr("Heading of the sensor, as sent"), fonts::small(), QStringLiteral("-000.00°"), this)),
      m_axis(new ValueLabel(tr("Azimuth of the axis"), fonts::small(), QStringLiteral("-000.00°"), this)),
      m_difference(new ValueLabel(tr("Sensor minus axis"), fonts::small(), QStringLiteral("-000.00°"), this)),
      m_truth(new ValueLabel(tr("True azimuth from the sensor and its uncertainty"), fonts::small(),
                             QStringLiteral("000.0° ± 00.0°"), this)),
      m_offset(new ValueLabel(tr("North from the sensor"), fonts::text(), {}, this)),
      m_run(new RunLine(CalibrationRun::SensorOffset, tr("Average of the sensor"), this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_declination(new DeclinationBox(desk, m_profileChange, *m_notice, m_overview)),
      m_measure(new CommandButton(tr("Average"), {}, desk, *m_notice, this))
{
    build();
    connect(m_measure, &QPushButton::clicked, this, &SensorPage::press);
    connect(m_openDetails, &QPushButton::toggled, this, &SensorPage::showDetails);
    connect(m_copy, &QPushButton::clicked, this, &SensorPage::copyDetails);
    connect(m_declination, &DeclinationBox::settingsWanted, this,
            [this] { Q_EMIT settingsWanted(QStringLiteral("declination")); });
    showDetails(false);
}

void SensorPage::build()
{
    auto* const values = new QGridLayout;
    values->setVerticalSpacing(0);
    const std::tuple<QString, ValueLabel*, int, int> places[] = {{tr("△ Sensor"), m_sensor, 0, 0},
                                                                 {tr("● Axis"), m_axis, 0, 2},
                                                                 {tr("Between them"), m_difference, 1, 0},
                                                                 {tr("True"), m_truth, 1, 2}};
    for (const auto& [text, value, row, column] : places) {
        values->addWidget(makeCaption(text, this), row, column);
        values->addWidget(value, row, column + 1);
    }
    values->setColumnStretch(4, 1);
    auto* const right = new QVBoxLayout;
    right->setSpacing(6);
    right->addLayout(values);
    right->addWidget(m_levels);
    right->addStretch(1);
    m_offset->setStretching(true);
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);  // shown in place of the offset, until the next press
    auto* const readings = new QHBoxLayout;
    readings->setSpacing(4);
    readings->addWidget(m_dial);
    readings->addLayout(right, 1);
    auto* const overview = new QVBoxLayout(m_overview);
    overview->setContentsMargins(0, 0, 0, 0);
    overview->setSpacing(4);
    overview->addLayout(readings);
    overview->addWidget(m_declination);
    overview->addStretch(1);
    m_table->horizontalHeader()->setStretchLastSection(true);
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(6, 4, 6, 0);
    grid->setSpacing(4);
    grid->addWidget(m_overview, 0, 0, 1, 2);
    grid->addWidget(m_table, 0, 0, 1, 2);
    grid->addWidget(m_measure, 1, 0);
    grid->addWidget(makeRunLine(), 1, 1);
    grid->addWidget(m_offset, 2, 0, 1, 2);
    grid->addWidget(m_notice, 3, 0, 1, 2);
    grid->setRowStretch(0, 1);
    grid->setColumnStretch(1, 1);
}

QWidget* SensorPage::makeRunLine()
{
    auto* const box = new QWidget(this);
    auto* const row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    m_openDetails->setCheckable(true);
    row->addWidget(m_run, 1);
    row->addWidget(m_copy);
    row->addWidget(m_openDetails);
    return box;
}

void SensorPage::showDetails(bool on)
{
    m_overview->setVisible(!on);
    m_table->setVisible(on);
    m_copy->setVisible(on);
}

void SensorPage::copyDetails() const
{
    QApplication::clipboard()->setText(m_details->text());
}

void SensorPage::showStatus(const StationStatus& status)
{
    m_details->show(status.sensor);
    const CalibrationStatus& calibration = calibrationOf(status);
    m_running = calibration.progress.run == CalibrationRun::SensorOffset;
    showNeedles(status);
    m_declination->showStatus(status);
    m_offset->setValue(averageText(calibration));
    m_offset->setVisible(m_notice->text().isEmpty());
    m_offers = status.simulated && !status.sensor.configured() && !calibration.sensorObstacle.isEmpty();
    if (m_offers) {
        showOffer(status);
    } else {
        showAverage(status);
    }
}

void SensorPage::showOffer(const StationStatus& status)
{
    m_run->showProgress(calibrationOf(status).progress,
                        tr("No sensor is set. The simulated mount has one on its boom"));
    m_measure->setCommand(tr("Use the sensor"), tr("Set sensor.source in the profile. Nothing moves"));
    m_measure->setBlocked(m_profileChange.whyNot(status, nameSimulatedSensor));
}

void SensorPage::showAverage(const StationStatus& status)
{
    const CalibrationStatus& calibration = calibrationOf(status);
    const QString reason = m_running ? QString() : status.permissions.reason(Action::AverageSensor);
    m_run->showProgress(calibration.progress, reason.isEmpty()
                                                  ? tr("Average the sensor for 20 s while the mount stands still")
                                                  : tr("Not now: %1").arg(reason));
    m_measure->setCommand(m_running ? tr("End average") : tr("Average"),
                          m_running ? tr("End without a result. Nothing moves") : tr("Nothing moves"));
    m_measure->setBlocked(reason);
}

void SensorPage::showNeedles(const StationStatus& status)
{
    const bool known = freshness(status.azimuth.age) != Freshness::NoData;
    const std::optional<Angle> axis = known ? status.azimuth.actual : std::nullopt;
    const bool lost = status.sensor.presence == orientation::Presence::Lost;
    const std::optional<orientation::Orientation> last = lost ? std::nullopt : status.sensor.last;
    m_dial->showNeedles(axis, last ? std::optional(last->heading) : std::nullopt);
    m_levels->showCalibration(last ? last->calibration : std::nullopt);
    m_sensor->setValue(last ? azimuthText(last->heading.angle(), 2) : noValue());
    m_axis->setValue(axis ? angleText(*axis) : noValue());
    m_truth->setValue(trueAzimuthText(status.sensor));
    m_difference->setValue(last && axis ? signedAngleText((last->heading.angle() - *axis).wrapped180()) : noValue());
}

void SensorPage::press()
{
    if (m_offers) {
        m_profileChange.ask(*m_measure, nameSimulatedSensor);
        return;
    }
    m_measure->ask(m_running ? Request(request::EndCalibration{}) : Request(request::MeasureSensorOffset{}));
}

}  // namespace boresight::ui

#include "moc_sensor_page.cpp"
