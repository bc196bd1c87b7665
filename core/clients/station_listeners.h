// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/control/station_control.h"
#include "core/listeners/listener.h"
#include "core/profile/in_force.h"
#include "core/rotctld/client_server.h"

#include <QObject>

#include <memory>
#include <vector>

// The listeners of the profile, for programs that do not speak rotctld. Each one is a server of its own for the same
// rotator, so its clients pass the same gates as rotctld clients. Station thread.
namespace boresight {

class StationListeners
{
public:
    // All arguments but the parent outlive this.
    StationListeners(StationControl& control, const profile::InForce& profile, EventLog& log, rotctld::Rotator& rotator,
                     const Clock& clock, std::shared_ptr<std::uint64_t> newestClient, QObject* parent);

    // One alarm names all listeners that cannot be opened.
    void open();
    void close() { m_servers.clear(); }
    void tick();
    // Applies another number of clients. The listeners themselves wait for Reconnect.
    void profileChanged();
    // False: the client is not one of these listeners' clients.
    bool disconnect(std::uint64_t client, const QString& reason);

    [[nodiscard]] std::vector<rotctld::ClientInfo> clients() const;
    [[nodiscard]] std::vector<std::string> addresses() const;

private:
    [[nodiscard]] std::unique_ptr<rotctld::ClientServer> serverOf(const listeners::Listener& listener) const;
    [[nodiscard]] bool isReadOnly(std::uint64_t client) const;

    StationControl& m_control;
    const profile::InForce& m_profile;
    EventLog& m_log;
    rotctld::Rotator& m_rotator;
    const Clock& m_clock;
    std::shared_ptr<std::uint64_t> m_newestClient;
    QObject* m_parent;
    std::vector<std::unique_ptr<rotctld::ClientServer>> m_servers;
};

}  // namespace boresight
