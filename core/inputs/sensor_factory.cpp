// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/sensor_factory.h"

#include "core/orientation_stream/mqtt_source.h"
#include "core/orientation_stream/serial_source.h"
#include "core/sim_sensor/simulated_source.h"

#include <tuple>

namespace boresight {

namespace {

orientation::MqttTopics topicsOf(const profile::SensorSettings& sensor)
{
    return {.orientation = QString::fromStdString(sensor.orientationTopic),
            .status = QString::fromStdString(sensor.statusTopic),
            .calibration = QString::fromStdString(sensor.calibrationTopic)};
}

}  // namespace

SensorMaker sensorMaker(const Clock& clock, std::shared_ptr<SimulatedMount> simulated)
{
    return [&clock, simulated](const profile::Profile& profile,
                               mqtt::Connection& broker) -> std::unique_ptr<orientation::SensorSource> {
        const profile::SensorSettings& sensor = profile.sensor;
        switch (sensor.source) {
            case profile::SensorSource::Serial:
                return std::make_unique<orientation::SerialSource>(
                    orientation::SerialSettings{.port = QString::fromStdString(sensor.port), .baud = sensor.baud},
                    clock);
            case profile::SensorSource::Simulated:
                return simulated ? std::make_unique<SimulatedSource>(clock, simulated) : nullptr;
            case profile::SensorSource::Mqtt:
                return std::make_unique<orientation::MqttSource>(broker, topicsOf(sensor), clock);
            case profile::SensorSource::None:
                break;
        }
        return nullptr;
    };
}

bool namesAnotherSensor(const profile::Profile& a, const profile::Profile& b)
{
    const auto key = [](const profile::SensorSettings& sensor) {
        return std::tie(sensor.source, sensor.port, sensor.baud, sensor.orientationTopic, sensor.statusTopic,
                        sensor.calibrationTopic);
    };
    return key(a.sensor) != key(b.sensor);
}

}  // namespace boresight
