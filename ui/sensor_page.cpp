// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sensor_page.h"

#include "ui/calibration_permission.h"
#include "ui/calibration_words.h"
#include "ui/command_button.h"
#include "ui/compass_dial.h"
#include "ui/format.h"
#include "ui/guide_fields.h"
#include "ui/run_line.h"
#include "ui/sensor_levels.h"
#include "ui/value_label.h"

#include <QGridLayout>
#include <QLabel>

#include <tuple>

namespace boresight::ui {

SensorPage::SensorPage(RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_dial(new CompassDial(this)),
      m_levels(new SensorLevels(this)),
      m_sensor(new ValueLabel(tr("Heading of the sensor, as sent"), fonts::small(), QStringLiteral("-000.00°"), this)),
      m_axis(new ValueLabel(tr("Azimuth of the axis"), fonts::small(), QStringLiteral("-000.00°"), this)),
      m_difference(new ValueLabel(tr("Sensor less axis"), fonts::small(), QStringLiteral("-000.00°"), this)),
      m_declination(new ValueLabel(tr("Who adds the declination"), fonts::label(), {}, this)),
      m_offset(new ValueLabel(tr("North from the sensor"), fonts::text(), {}, this)),
      m_run(new RunLine(CalibrationRun::SensorOffset, tr("Average of the sensor"), this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_measure(new CommandButton(tr("Average"), {}, desk, *m_notice, this))
{
    build();
    connect(m_measure, &QPushButton::clicked, this, &SensorPage::measureOrEnd);
}

void SensorPage::build()
{
    auto* const values = new QGridLayout;
    values->setVerticalSpacing(0);
    const std::tuple<QString, ValueLabel*, int, int> places[] = {
        {tr("△ Sensor"), m_sensor, 0, 0}, {tr("● Axis"), m_axis, 0, 2}, {tr("Between them"), m_difference, 1, 0}};
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
    for (ValueLabel* const line : {m_declination, m_offset, m_notice}) {
        line->setStretching(true);
    }
    m_declination->setLines(2);
    m_notice->setCollapsing(true);  // in the place of the offset, until the next press
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(6, 4, 6, 0);
    grid->setSpacing(4);
    grid->addWidget(m_dial, 0, 0);
    grid->addLayout(right, 0, 1);
    grid->addWidget(m_declination, 1, 0, 1, 2);
    grid->addWidget(m_measure, 2, 0);
    grid->addWidget(m_run, 2, 1);
    grid->addWidget(m_offset, 3, 0, 1, 2);
    grid->addWidget(m_notice, 4, 0, 1, 2);
    grid->setRowStretch(0, 1);
    grid->setColumnStretch(1, 1);
}

void SensorPage::showStatus(const StationStatus& status)
{
    const CalibrationStatus& calibration = calibrationOf(status);
    m_running = calibration.progress.run == CalibrationRun::SensorOffset;
    showNeedles(status);
    m_declination->setValue(status.sensor.declinationText, Tone::Secondary);
    const QString reason = m_running ? QString() : whyNoSensorAverage(status);
    m_run->showProgress(calibration.progress,
                        reason.isEmpty()
                            ? tr("The mount stands still, motors at rest; the sensor is averaged for some 20 s")
                            : tr("Not now: %1").arg(reason));
    m_offset->setValue(calibration.sensorOffset ? tr("North: axis %1").arg(offsetText(calibration.sensorOffset->offset))
                                                : QString());
    m_offset->setVisible(m_notice->text().isEmpty());
    m_measure->setCommand(m_running ? tr("End average") : tr("Average"),
                          m_running ? tr("No result; nothing moves anyway") : tr("Nothing moves"));
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
    m_sensor->setValue(last ? angleText(last->heading.angle()) : noValue());
    m_axis->setValue(axis ? angleText(*axis) : noValue());
    m_difference->setValue(last && axis ? signedAngleText((last->heading.angle() - *axis).wrapped180()) : noValue());
}

void SensorPage::measureOrEnd()
{
    m_measure->ask(m_running ? Request(request::EndCalibration{}) : Request(request::MeasureSensorOffset{}));
}

}  // namespace boresight::ui
