// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/mqtt_commands/command_talk.h"
#include "core/profile/in_force.h"
#include "core/rotctld/server.h"
#include "core/station/station_broker.h"

#include <QObject>

#include <memory>
#include <vector>

// The commands that arrive by the MQTT broker, where the profile permits them. Those who write to its topics are one
// client of the mount while the broker is connected, and another one after the next connection. Station thread.
namespace boresight {

class MessageCommands : public QObject
{
    Q_OBJECT

public:
    // All but the parent outlive this. `newestClient` is that of all servers of this rotator.
    MessageCommands(AlarmBoard& alarms, const profile::InForce& profile, EventLog& log, const Clock& clock,
                    StationBroker& broker, rotctld::Rotator& rotator, std::shared_ptr<std::uint64_t> newestClient,
                    mqtt::LatchStop latchStop, QObject* parent);

    void open();
    void close();
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Ends the client of a connection that is lost.
    void tick();
    // False: the client is not of the broker. Else it begins anew, without the control.
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
    // Empty: not opened.
    QString m_commandTopic;
    QString m_stopTopic;
    QString m_answerTopic;
    std::shared_ptr<mqtt::CommandTalk> m_talk;  // while the broker is connected
};

}  // namespace boresight
