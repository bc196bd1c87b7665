// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_sensor/sensor_publisher.h"

namespace boresight::sim {

using orientation::Topic;

SensorPublisher::SensorPublisher(SensorBox& box, const Clock& clock, const QString& prefix, PublishedTopics topics)
    : m_clock(clock), m_prefix(prefix), m_client(clock)
{
    if (topics == PublishedTopics::All) {
        m_beside = {
            {.topic = Topic::Calibration, .name = QStringLiteral("calibration"), .period = kCalibrationPeriod},
            {.topic = Topic::Status, .name = QStringLiteral("status"), .period = kStatusPeriod},
        };
    }
    connect(&box, &SensorBox::said, this, &SensorPublisher::publish);
}

void SensorPublisher::publish(const SensorMessage& message)
{
    const SteadyTime now = m_clock.now();
    for (Beside& beside : m_beside) {
        const bool due = !beside.last || now - *beside.last >= beside.period;
        if (due && send(beside.name, message, beside.topic)) {
            beside.last = now;
        }
    }
    send(QStringLiteral("orientation"), message, Topic::Orientation);
}

bool SensorPublisher::send(const QString& name, const SensorMessage& message, Topic topic)
{
    return m_client.publish({.topic = m_prefix + name, .payload = toPayload(message, topic)});
}

}  // namespace boresight::sim

#include "moc_sensor_publisher.cpp"
