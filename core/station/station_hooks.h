// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/inputs/station_broker.h"
#include "core/profile/in_force.h"
#include "core/programs/program_runner.h"
#include "core/schedule/pass_moment.h"

#include <QObject>

// At a moment of the schedule, starts a program of the profile and sends a message to the broker. The result of the
// program is a line in the log and has no other effect. Station thread.
namespace boresight {

class StationHooks : public QObject
{
    Q_OBJECT

public:
    // Profile, log and broker outlive this.
    StationHooks(const profile::InForce& profile, bool simulated, EventLog& log, StationBroker& broker,
                 QObject* parent);

    void tell(const schedule::PassMoment& moment);

private:
    const profile::InForce& m_profile;
    bool m_simulated;
    EventLog& m_log;
    StationBroker& m_broker;
    programs::ProgramRunner m_runner;
};

}  // namespace boresight
