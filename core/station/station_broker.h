// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/alarms/log_throttle.h"
#include "core/messages/station_status.h"
#include "core/mqtt/state_publisher.h"
#include "core/mqtt/threaded_client.h"
#include "core/profile/in_force.h"

#include <QByteArray>
#include <QObject>

#include <memory>
#include <optional>
#include <vector>

// The MQTT broker as the station uses it: one connection, by which the station's state goes out and the sensor's
// messages come in. What happens to it is logged and never moves or stops anything. Station thread; the broker
// itself is served by a thread of its own.
namespace boresight {

// The broker of the profile, for a connection with this name where the profile has none.
[[nodiscard]] mqtt::Broker brokerOf(const profile::BrokerSettings& settings, const QString& ownId);

class StationBroker : public QObject
{
    Q_OBJECT

public:
    // Profile, log and clock outlive this; any thread may read the clock.
    StationBroker(const profile::InForce& profile, EventLog& log, const Clock& clock, QObject* parent);

    // Connects if somebody needs the broker.
    void open() { connectAnew(); }
    // What did not change stays as it is.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Whether the orientation sensor comes by the broker.
    void setSensorWanted(bool wanted);
    // Somebody reads a topic of the broker, and reads it no more.
    void addReader();
    void removeReader();
    void close();

    [[nodiscard]] mqtt::Connection& connection() { return m_client; }
    [[nodiscard]] bool isPublishing() const { return m_publisher != nullptr && m_client.isConnected(); }
    // To be called some times a second, while it publishes.
    void show(const StationStatus& status);
    // What has no reader now is lost.
    void tell(const QByteArray& momentOfTheSchedule);
    [[nodiscard]] BrokerStatus status() const;

private:
    void connectAnew();
    [[nodiscard]] bool isReadFrom() const { return m_sensorWanted || m_readers > 0; }
    void stopPublishing();
    void publishAll(const std::vector<mqtt::Message>& messages);
    [[nodiscard]] std::optional<Seconds> untilNext() const;

    const profile::InForce& m_profile;
    EventLog& m_log;
    const Clock& m_clock;
    QString m_ownId;      // while the profile has none
    LogThrottle m_lines;  // about messages that others cause at will
    mqtt::ThreadedClient m_client;
    std::unique_ptr<mqtt::StatePublisher> m_publisher;
    std::vector<mqtt::Message> m_description;  // for Home Assistant; empty: it is not wanted
    bool m_sensorWanted = false;
    int m_readers = 0;  // besides the sensor
};

}  // namespace boresight
