// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/control/station_control.h"
#include "core/profile/in_force.h"
#include "core/rotctld/server.h"
#include "core/station/station_listeners.h"
#include "core/station/station_rotator.h"

#include <memory>
#include <vector>

// The rotctld server of a station, by the profile: where it listens, who may connect, what the log and the alarms say
// about it, and its clients as the screen shows them, with those of the further listeners. Station thread.
namespace boresight {

class StationServer
{
public:
    // All of them outlive this.
    StationServer(StationControl& control, const profile::InForce& profile, EventLog& log, const Clock& clock,
                  QObject* parent);

    // Where it does not listen there is an alarm, too.
    Result<> open();
    void close();
    void profileChanged();
    // NotAvailable: it has gone by itself.
    Result<> disconnect(std::uint64_t client, const QString& reason);

    [[nodiscard]] std::uint16_t port() const { return m_server.port(); }
    [[nodiscard]] QString address() const;  // empty: it does not listen
    // Those of the listeners, and others of the same rotator.
    [[nodiscard]] std::vector<ClientStatus> clients(std::vector<rotctld::ClientInfo> others) const;
    [[nodiscard]] rotctld::Rotator& rotator() { return m_rotator; }
    [[nodiscard]] const std::shared_ptr<std::uint64_t>& newestClient() const { return m_server.newestClient(); }

private:
    void tellOpenPort();

    StationControl& m_control;
    const profile::InForce& m_profile;
    EventLog& m_log;
    StationRotator m_rotator;
    rotctld::Server m_server;  // they end before the rotator
    StationListeners m_further;
};

}  // namespace boresight
