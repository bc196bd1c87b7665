// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_sensor.h"

#include "core/base/text.h"
#include "core/geomagnetism/coefficient_file.h"
#include "core/geomagnetism/decimal_year.h"
#include "core/geomagnetism/magnetic_model.h"

#include <utility>

namespace boresight {
namespace {

const QString kSensorSource = QStringLiteral("sensor");

}  // namespace

StationSensor::StationSensor(const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms,
                             StationBroker& broker, QObject* parent)
    : QObject(parent),
      m_profile(profile),
      m_clock(clock),
      m_log(log),
      m_broker(broker),
      m_watch(profile, clock, log, alarms),
      m_maker(sensorMaker(clock, nullptr))
{
    m_reader.setMaxThreadCount(1);
    connect(this, &StationSensor::modelRead, this, &StationSensor::takeModel);
}

void StationSensor::open()
{
    close();
    m_open = true;
    m_source = m_maker(*m_profile, m_broker.connection());
    m_broker.setSensorWanted(m_profile->sensor.source == profile::SensorSource::Mqtt);
    readModel();
    if (!m_source) {
        return;
    }
    connect(m_source.get(), &orientation::SensorSource::received, this, [this](const orientation::Orientation& value) {
        const profile::SensorSettings& settings = m_profile->sensor;
        m_watch.take(orientation::asMounted(value, settings.mounting.elevationSense, settings.declinationInSensor));
        m_watch.show(m_source->status());
    });
    connect(m_source.get(), &orientation::SensorSource::statusChanged, this,
            [this](const orientation::SourceStatus& status) {
                m_watch.show(status);
                // A problem of the broker is already in the log.
                if (!status.problem.isEmpty() && status.problem != m_broker.connection().problem()) {
                    m_log.add(Severity::Warning, kSensorSource, status.problem);
                }
            });
    m_watch.begin(m_source->name());
    m_source->open();
    m_watch.show(m_source->status());
}

// The counts of refused messages and the firmware do not depend on a value, so they come from the source.
SensorStatus StationSensor::status() const
{
    SensorStatus status = m_watch.status();
    if (!m_source) {
        return status;
    }
    const orientation::SourceStatus& source = m_source->status();
    status.counts = source.counts;
    if (source.firmware) {
        status.firmware = source.firmware->value;
        status.firmwareAge =
            std::chrono::duration_cast<std::chrono::milliseconds>(m_clock.now() - source.firmware->arrival);
    }
    return status;
}

void StationSensor::close()
{
    m_open = false;
    if (m_source) {
        m_source->disconnect(this);
        m_source->close();
        m_source.reset();
    }
    m_watch.begin({});
}

void StationSensor::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    const bool another = namesAnotherSensor(before, after);
    const bool elsewhere = before.site != after.site || before.sensor.declinationFile != after.sensor.declinationFile;
    m_watch.profileChanged(before, after);
    if (elsewhere) {
        m_watch.setSiteDeclination(std::nullopt);  // it was for the previous site or file
    }
    if (m_open && another) {
        open();
    } else if (m_open && elsewhere) {
        readModel();
    }
}

bool StationSensor::hasModel() const
{
    return !m_profile->sensor.declinationFile.empty() && m_profile->site.known;
}

void StationSensor::readModel()
{
    if (!hasModel()) {
        return;
    }
    if (std::exchange(m_isReading, true)) {
        m_readAgain = true;
        return;
    }
    m_reader.start([this, path = toQString(m_profile->sensor.declinationFile), site = m_profile->site.place(),
                    year = geomagnetism::decimalYear(m_clock.utc())] {
        m_model = askModel(path, site, year);
        Q_EMIT modelRead();
    });
}

StationSensor::ModelAnswer StationSensor::askModel(const QString& path, const Site& site, double year)
{
    ModelAnswer answer;
    answer.declination = geomagnetism::readCoefficients(path).and_then(
        [&](const geomagnetism::Coefficients& coefficients) -> Result<Angle> {
            const geomagnetism::MagneticModel model(coefficients);
            answer.model = Text::tr("%1, %2 to %3")
                               .arg(toQString(model.name()))
                               .arg(model.validFrom(), 0, 'f', 1)
                               .arg(model.validTo(), 0, 'f', 1);
            answer.expiry = model.expiry(year);
            return model.at(site, year).map([](const geomagnetism::MagneticField& field) {
                return field.now.declination;
            });
        });
    return answer;
}

void StationSensor::takeModel()
{
    const ModelAnswer answer = std::move(m_model);
    m_isReading = false;
    if (std::exchange(m_readAgain, false) || !hasModel()) {
        readModel();
        return;
    }
    m_watch.setSiteDeclination(answer.declination, answer.model, answer.expiry);
    if (!answer.declination) {
        m_log.add(Severity::Warning, kSensorSource, answer.declination.error().text);
    } else if (!answer.expiry.isEmpty()) {
        m_log.add(Severity::Warning, kSensorSource, answer.expiry);
    }
}

}  // namespace boresight

#include "moc_station_sensor.cpp"
