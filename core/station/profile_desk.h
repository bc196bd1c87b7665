// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/messages/request.h"
#include "core/north/calibration_change.h"
#include "core/profile/in_force.h"

#include <functional>
#include <optional>

// Changes the profile in force, by requests of the operator, by a calibration or by a file that was read again. Each
// changed setting is a line in the log. It also keeps the profile of the next station. Station thread only.
namespace boresight {

class ProfileDesk
{
public:
    // Called when another profile is in force. `wanted` also has the settings that wait for Reconnect.
    using Applied = std::function<void(const profile::Profile& before, const profile::Profile& wanted)>;

    // Profile and log outlive this. `simulated`: the connected mount is simulated.
    ProfileDesk(profile::InForce& profile, bool simulated, EventLog& log, Applied applied);

    // Both carry out a request that StationControl has admitted. The error explains why the mount does not permit it.
    Result<> carryOut(const request::ApplyProfile& request);
    Result<> carryOut(const request::Reconnect& request);
    // Applies the result of a calibration like a change by the operator.
    void apply(const CalibrationChange& change);
    // Logs what became of a profile that was read again.
    void reportReading(const Result<>& taken);

    // The profile for the reconnect. Empty: no reconnect is wanted.
    [[nodiscard]] const std::optional<profile::Profile>& next() const { return m_next; }

private:
    [[nodiscard]] Result<> fits(const profile::Profile& wanted) const;
    [[nodiscard]] Result<> mayConnect(const profile::Profile& next) const;
    void put(const profile::Profile& wanted);

    profile::InForce& m_profile;
    bool m_simulated;
    EventLog& m_log;
    Applied m_applied;
    std::optional<profile::Profile> m_next;
};

}  // namespace boresight
