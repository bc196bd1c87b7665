// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/sensor_readout.h"

#include "ui/kit/format.h"
#include "ui/kit/value_label.h"
#include "ui/window/calibration_bars.h"

#include <QGridLayout>

#include <cmath>

namespace boresight::ui {

namespace {

// In tenths of a degree: a compass is not more accurate.
QString directionText(const SensorStatus& sensor)
{
    return sensor.direction
               ? SensorReadout::tr("Sensor %1 %2")
                     .arg(azimuthText(sensor.direction->azimuth, 1), angleText(sensor.direction->elevation, 1))
               : SensorReadout::tr("Sensor %1").arg(noValue());
}

QString difference(const QString& name, const std::optional<Angle>& angle)
{
    return angle ? name + QLatin1Char(' ') + signedAngleText(*angle) : QString();
}

// A sensor behind a broker that cannot be reached has the problem of that broker.
QString problemText(const SensorStatus& sensor, const BrokerStatus& broker)
{
    const bool waits = broker.retryIn && sensor.problem == broker.problem && !sensor.problem.isEmpty();
    return waits ? SensorReadout::tr("Broker not reached, next attempt in %1 s. %2")
                       .arg(std::ceil(broker.retryIn->count()), 0, 'f', 0)
                       .arg(sensor.problem)
                 : sensor.problem;
}

// The worst trouble first. If all is well: the difference from the axes.
QString detailText(const SensorStatus& sensor, const BrokerStatus& broker)
{
    for (const QString& trouble : {problemText(sensor, broker), sensor.doubt}) {
        if (!trouble.isEmpty()) {
            return trouble;
        }
    }
    QStringList parts{difference(SensorReadout::tr("AZ"), sensor.azimuthDifference),
                      difference(SensorReadout::tr("EL"), sensor.elevationDifference)};
    parts.removeAll(QString());
    return parts.isEmpty() ? QString()
                           : SensorReadout::tr("sensor minus axes: %1").arg(parts.join(QLatin1String(", ")));
}

bool isWell(const SensorStatus& sensor)
{
    return sensor.presence == orientation::Presence::Present && !sensor.dead && !sensor.disagrees;
}

}  // namespace

SensorReadout::SensorReadout(QWidget* parent)
    : QWidget(parent),
      m_direction(new ValueLabel(tr("Direction by the sensor"), fonts::text(),
                                 tr("Sensor %1 %2").arg(QStringLiteral("000.0°"), QStringLiteral("-000.0°")), this)),
      m_age(new ValueLabel(tr("Age of the sensor's value"), fonts::label(), tr("age %1").arg(QStringLiteral("000.0 s")),
                           this)),
      m_detail(new ValueLabel(tr("Sensor against the axes"), fonts::label(), {}, this)),
      m_bars(new CalibrationBars(this))
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(0);
    m_direction->setSymbolRoom(true);
    m_detail->setStretching(true);
    m_detail->setBySentences(true);
    m_age->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(m_direction, 0, 0);
    grid->addWidget(m_bars, 0, 1, 1, 2, Qt::AlignRight);
    grid->addWidget(m_detail, 1, 0, 1, 2);
    grid->addWidget(m_age, 1, 2);
    grid->setColumnStretch(1, 1);
    hide();
}

void SensorReadout::showStatus(const SensorStatus& sensor, const BrokerStatus& broker)
{
    m_isConfigured = sensor.configured();
    setVisible(m_isConfigured && m_hasRoom);
    if (!m_isConfigured) {
        return;
    }
    const bool well = isWell(sensor);
    m_direction->setValue(directionText(sensor), sensor.direction ? Tone::Sensor : Tone::Secondary,
                          sensor.direction ? Symbol::Sensor : Symbol::Lost);
    m_age->setValue(sensor.age ? tr("age %1").arg(ageText(*sensor.age)) : QString(),
                    well ? Tone::Secondary : Tone::Warning);
    m_detail->setValue(detailText(sensor, broker), well && sensor.problem.isEmpty() ? Tone::Secondary : Tone::Warning);
    m_bars->showCalibration(sensor.direction && sensor.last ? sensor.last->calibration : std::nullopt);
}

void SensorReadout::setRoom(bool has)
{
    m_hasRoom = has;
    setVisible(m_isConfigured && m_hasRoom);
}

}  // namespace boresight::ui

#include "moc_sensor_readout.cpp"
