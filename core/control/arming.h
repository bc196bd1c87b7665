// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/messages/station_status.h"
#include "core/mount/mount_driver.h"
#include "core/profile/in_force.h"
#include "core/supervision/retry_policy.h"

#include <QString>

#include <array>
#include <optional>
#include <vector>

// May the mount move at all, and if not, why, and how does it come back? Keeps what can stand in the way: the bus left
// to others, drives that are silent, have only just come back or are not fit, the STOP latch, lost drives, and who has
// the authority. A lost drive latches a fault, and the way out is a re-arm: by a person, or by the profile's recovery
// policy. Starts no motion and ends none. Station thread only.
namespace boresight {

// What no client may ask.
[[nodiscard]] Result<> operatorOnly(const Source& source);

// How the operator takes the authority from the clients.
enum class Taking
{
    Explicitly,
    ByAct  // a motion, STOP, a re-arm: whatever clients must not undo at once
};

class Arming
{
public:
    Arming(const profile::InForce& profile, MountDriver& mount, EventLog& log);

    // May the mount be moved at all, whoever wants it?
    [[nodiscard]] Result<> isReady() const;
    // May this source start a motion? The error names what is in the way and how to remove it.
    [[nodiscard]] Result<> admits(const Source& source) const;
    // Has this source the control authority, whatever else stands in the way?
    [[nodiscard]] Result<> mayCommand(const Source& source) const;

    // Nothing moves until reset; a STOP also takes the authority from the clients.
    void latchStop();
    [[nodiscard]] Result<> mayResetStop() const;
    Result<> resetStop();
    [[nodiscard]] bool stopLatched() const { return m_stopLatched; }

    // The operator has the authority from now on, by an explicit request for it or by another act.
    void takeAuthority(Taking how);
    void giveAuthority();
    [[nodiscard]] Authority authority() const { return m_authority; }
    // It was taken by an act of the operator that was about something else, and not explicitly since.
    [[nodiscard]] bool tookByAct() const { return m_taken == Taking::ByAct; }

    // The program ends: no start and no re-arm from now on.
    void close() { m_closing = true; }
    [[nodiscard]] bool closing() const { return m_closing; }

    // First in a tick, after the replies were judged. True once when the connection to a drive was lost.
    [[nodiscard]] bool losesConnection(SteadyTime now);
    [[nodiscard]] bool connected() const { return m_connected; }

    // Latches the fault. `reason` in words: "azimuth drive: over temperature (38)"; the first one of a series stays.
    void lost(Axis axis, supervision::LossClass kind, const QString& reason);
    [[nodiscard]] std::optional<QString> fault() const;
    // What stands in the way of a re-arm.
    [[nodiscard]] Result<> mayRearm(const Source& source) const;
    // Clears faults and time-outs of the drives; done when completesRearm() says so.
    Result<> rearm(const Source& source);
    // Once in a tick, after its losses: re-arms by the policy when it is time. True once when a re-arm is done.
    [[nodiscard]] bool completesRearm();

private:
    struct Loss
    {
        Axis axis = Axis::Azimuth;
        supervision::LossClass kind = supervision::LossClass::Motion;
        QString reason;
        supervision::DriveConditions conditions;
    };

    [[nodiscard]] QString rearmObstacle() const;
    [[nodiscard]] supervision::DriveConditions conditions(Axis axis) const;
    void noteConditions(Axis axis);
    void beginRearm();
    void retry();

    const profile::InForce& m_profile;
    MountDriver& m_mount;
    EventLog& m_log;
    supervision::RetryPolicy m_retry;
    Authority m_authority = Authority::Clients;
    std::optional<Taking> m_taken;  // by the operator, since the clients had it
    bool m_stopLatched = false;
    bool m_closing = false;
    bool m_connected = false;
    bool m_wasConnected = false;
    SteadyTime m_quietUntil{};                             // no motion right after a connection came back
    std::vector<Loss> m_losses;                            // since the last re-arm; any of them latches the fault
    std::array<supervision::DriveConditions, 2> m_told{};  // the last report of each drive
    bool m_rearming = false;
    SteadyTime m_now{};  // of the running or last tick
};

}  // namespace boresight
