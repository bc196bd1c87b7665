// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/profile/in_force.h"
#include "core/rotctld/server.h"

#include <memory>
#include <vector>

// The listeners for programs that do not speak rotctld, by the profile. Each is a server of its own in front of the
// same rotator, so that its clients pass what rotctld clients pass. Station thread.
namespace boresight {

class StationListeners
{
public:
    // All of them outlive this.
    StationListeners(AlarmBoard& alarms, const profile::InForce& profile, EventLog& log, rotctld::Rotator& rotator,
                     const Clock& clock, std::shared_ptr<std::uint64_t> newestClient, QObject* parent);

    // Those that cannot be opened are named by one alarm.
    void open();
    void close() { m_servers.clear(); }
    // False when it is none of theirs.
    bool disconnect(std::uint64_t client, const QString& reason);

    [[nodiscard]] std::vector<rotctld::ClientInfo> clients() const;
    [[nodiscard]] std::vector<std::string> addresses() const;

private:
    AlarmBoard& m_alarms;
    const profile::InForce& m_profile;
    EventLog& m_log;
    rotctld::Rotator& m_rotator;
    const Clock& m_clock;
    std::shared_ptr<std::uint64_t> m_newestClient;
    QObject* m_parent;
    std::vector<std::unique_ptr<rotctld::Server>> m_servers;
};

}  // namespace boresight
