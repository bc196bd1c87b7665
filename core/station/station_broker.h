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

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The connection of the station to the MQTT broker. It publishes the state of the station and receives messages, for
// example of the sensor. Problems with the broker are logged. They never move or stop the mount. Station thread; a
// thread of its own serves the broker.
namespace boresight {

class StationBroker : public QObject
{
    Q_OBJECT

public:
    // Profile, log and clock outlive this. Any thread may read the clock.
    StationBroker(const profile::InForce& profile, EventLog& log, const Clock& clock, QObject* parent);

    // Connects to the broker if it is needed for publishing or for a reader.
    void open() { connectAnew(); }
    // Reconnects only if the settings of the broker have changed.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Whether the messages of the orientation sensor come by the broker.
    void setSensorWanted(bool wanted);
    // As mqtt::ThreadedClient.
    void keepUrgent(mqtt::UrgencyOf urgencyOf) { m_client.keepUrgent(std::move(urgencyOf)); }
    // A reader of a topic begins, and ends.
    void addReader();
    void removeReader();
    void close();

    [[nodiscard]] mqtt::Connection& connection() { return m_client; }
    [[nodiscard]] bool isPublishing() const { return m_publisher != nullptr && m_client.isConnected(); }
    // Call several times a second while isPublishing().
    void show(const StationStatus& status);
    // Publishes a moment of the schedule. It is lost unless isPublishing().
    void tell(const QByteArray& momentOfTheSchedule);
    [[nodiscard]] BrokerStatus status() const;

private:
    using Address = std::pair<std::string, int>;  // host and port

    void connectAnew();
    [[nodiscard]] bool isReadFrom() const { return m_sensorWanted || m_readers > 0; }
    void stopPublishing();
    void describe(const profile::Profile& before, const profile::Profile& after);
    void withdrawOwed();
    void publishAll(const std::vector<mqtt::Message>& messages);
    [[nodiscard]] std::optional<Seconds> untilNext() const;

    const profile::InForce& m_profile;
    EventLog& m_log;
    const Clock& m_clock;
    QString m_ownId;      // the client id while the profile has none
    LogThrottle m_lines;  // limits the lines that others can cause at will
    mqtt::ThreadedClient m_client;
    std::unique_ptr<mqtt::StatePublisher> m_publisher;
    std::vector<mqtt::Message> m_description;  // for Home Assistant; empty: not wanted
    // What removes entities at a broker that was away when they were withdrawn.
    std::map<Address, std::vector<mqtt::Message>> m_owed;
    bool m_sensorWanted = false;
    int m_readers = 0;  // without the sensor
};

}  // namespace boresight
