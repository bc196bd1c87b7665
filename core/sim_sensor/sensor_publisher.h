// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker_client.h"
#include "core/sim_sensor/sensor_box.h"

#include <QObject>

#include <chrono>
#include <optional>

// The simulated orientation sensor at an MQTT broker, with the behaviour of its firmware: quality of service 0, nothing
// retained, no will, no user. PREFIXorientation about once a second, PREFIXcalibration every 10 s, PREFIXstatus every
// minute. Lives on the thread of its event loop. Never blocks. Messages without a connection are lost.
namespace boresight::sim {

enum class PublishedTopics
{
    All,
    OrientationOnly  // the only topic of firmware since March 2026
};

class SensorPublisher final : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kCalibrationPeriod{10};
    static constexpr std::chrono::seconds kStatusPeriod{60};

    // Box and clock outlive the publisher.
    SensorPublisher(SensorBox& box, const Clock& clock, const QString& prefix,
                    PublishedTopics topics = PublishedTopics::All);

    // For opening the connection, and for reports of its problems.
    [[nodiscard]] mqtt::BrokerClient& client() { return m_client; }

private:
    struct Beside
    {
        orientation::Topic topic;
        QString name;
        std::chrono::seconds period;
        std::optional<SteadyTime> last{};
    };
    void publish(const SensorMessage& message);
    bool send(const QString& name, const SensorMessage& message, orientation::Topic topic);

    const Clock& m_clock;
    QString m_prefix;
    std::vector<Beside> m_beside;
    mqtt::BrokerClient m_client;
};

}  // namespace boresight::sim
