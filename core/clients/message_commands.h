// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/inputs/station_broker.h"
#include "core/mqtt_commands/command_talk.h"
#include "core/profile/in_force.h"
#include "core/rotctld/client_server.h"

#include <QObject>

#include <memory>
#include <vector>

// Receives commands by the MQTT broker, where the profile permits them. All senders to its topics together are one
// client of the mount. Each new connection to the broker makes a new client. Station thread.
namespace boresight {

class MessageCommands : public QObject
{
    Q_OBJECT

public:
    // All arguments but the parent outlive this. All servers of this rotator share `newestClient`.
    MessageCommands(AlarmBoard& alarms, const profile::InForce& profile, EventLog& log, const Clock& clock,
                    StationBroker& broker, rotctld::Rotator& rotator, std::shared_ptr<std::uint64_t> newestClient,
                    mqtt::LatchStop latchStop, QObject* parent);

    void open();
    void close();
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Ends the client when the connection to the broker is lost.
    void tick();
    // Replaces the client by a new one without control authority. False: it is not the client of the broker.
    bool disconnect(std::uint64_t client, const QString& reason);

    [[nodiscard]] std::vector<rotctld::ClientInfo> clients() const;

private:
    void tellOpenBroker();
    void begin();
    void end(const QString& reason);
    void take(const QString& topic, const QByteArray& payload, mqtt::Retain retain);

    AlarmBoard& m_alarms;
    const profile::InForce& m_profile;
    EventLog& m_log;
    const Clock& m_clock;
    StationBroker& m_broker;
    rotctld::Rotator& m_rotator;
    std::shared_ptr<std::uint64_t> m_newestClient;
    mqtt::LatchStop m_latchStop;
    // The topics are empty while not open.
    QString m_commandTopic;
    QString m_stopTopic;
    QString m_answerTopic;
    std::shared_ptr<mqtt::CommandTalk> m_talk;  // while the broker is connected
};

}  // namespace boresight
