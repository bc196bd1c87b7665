// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/clients/logged_rotator.h"
#include "core/clients/protocol_log.h"
#include "core/clients/station_listeners.h"
#include "core/clients/station_rotator.h"
#include "core/control/station_control.h"
#include "core/profile/in_force.h"
#include "core/rotctld/server.h"

#include <memory>
#include <vector>

// The rotctld server of a station. The profile says where it listens and who may connect. This class writes the log
// lines and alarms about the server, and lists its clients and those of the other listeners for the screen. Station
// thread.
namespace boresight {

class StationServer
{
public:
    // All arguments but the parent outlive this.
    StationServer(StationControl& control, const profile::InForce& profile, EventLog& log, const Clock& clock,
                  QObject* parent);

    // A server that cannot listen also raises an alarm.
    Result<> open();
    void close();
    void tick() { m_further.tick(); }
    void profileChanged();
    // NotAvailable: the client has already disconnected.
    Result<> disconnect(std::uint64_t client, const QString& reason);

    [[nodiscard]] std::uint16_t port() const { return m_server.port(); }
    [[nodiscard]] QString address() const;  // empty: it does not listen
    // Adds the clients of the listeners and `others`, which use the same rotator.
    [[nodiscard]] std::vector<ClientStatus> clients(std::vector<rotctld::ClientInfo> others) const;
    [[nodiscard]] rotctld::Rotator& rotator() { return m_logged; }
    [[nodiscard]] ProtocolLog& protocolLog() { return m_protocolLog; }
    [[nodiscard]] const ProtocolLog& protocolLog() const { return m_protocolLog; }
    [[nodiscard]] const std::shared_ptr<std::uint64_t>& newestClient() const { return m_server.newestClient(); }

private:
    void tellOpenPort();

    StationControl& m_control;
    const profile::InForce& m_profile;
    EventLog& m_log;
    StationRotator m_rotator;
    ProtocolLog m_protocolLog;
    LoggedRotator m_logged;    // the rotator of all servers
    rotctld::Server m_server;  // after the rotator, so that its clients end first
    StationListeners m_further;
};

}  // namespace boresight
