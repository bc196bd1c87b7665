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

// Whether the mount may move at all, what is in the way, and how to remove it. Keeps the possible obstacles: the bus
// is released to other tools, a drive is silent or has just come back, the drives are not fit, STOP is latched, a
// drive was lost, the source lacks the control authority. A lost drive latches a fault. Only a re-arm clears a fault,
// by a person or by the recovery policy of the profile. Starts no motion and ends none. Station thread only.
namespace boresight {

// Refuses every source but the operator.
[[nodiscard]] Result<> operatorOnly(const Source& source);

// How the operator takes the authority from the clients.
enum class Taking
{
    Explicitly,
    ByAct  // a motion, STOP or a re-arm, which clients must not undo at once
};

class Arming
{
public:
    Arming(const profile::InForce& profile, MountDriver& mount, EventLog& log);

    // Whether the mount may be moved at all, by any source.
    [[nodiscard]] Result<> isReady() const;
    // Whether this source may start a motion. The error names what is in the way and how to remove it.
    [[nodiscard]] Result<> admits(const Source& source) const;
    // Whether this source has the control authority. Judges nothing else.
    [[nodiscard]] Result<> mayCommand(const Source& source) const;

    // Nothing moves until the reset. STOP also takes the authority from the clients.
    void latchStop();
    [[nodiscard]] Result<> mayResetStop() const;
    Result<> resetStop();
    [[nodiscard]] bool stopLatched() const { return m_stopLatched; }

    // The operator has the authority from this call on.
    void takeAuthority(Taking how);
    void giveAuthority();
    [[nodiscard]] Authority authority() const { return m_authority; }
    // The operator got the authority by an act such as a motion, and has not taken it explicitly since.
    [[nodiscard]] bool tookByAct() const { return m_taken == Taking::ByAct; }

    // The program ends: no motion starts and no re-arm begins after this call.
    void close() { m_closing = true; }
    [[nodiscard]] bool closing() const { return m_closing; }

    // First call of a tick, after the replies were judged. True in the one tick in which the connection to a drive is
    // lost.
    [[nodiscard]] bool losesConnection(SteadyTime now);
    [[nodiscard]] bool connected() const { return m_connected; }

    // Latches the fault. `reason` is a text like "azimuth drive: over temperature (38)". If several drives are lost,
    // the first reason stays.
    void lost(Axis axis, supervision::LossClass kind, const QString& reason);
    [[nodiscard]] std::optional<QString> fault() const;
    // The error names what is in the way of a re-arm.
    [[nodiscard]] Result<> mayRearm(const Source& source) const;
    // Clears faults and time-outs of the drives. The re-arm is complete when completesRearm() is true.
    Result<> rearm(const Source& source);
    // Once in a tick, after the losses of the tick. Starts a re-arm by the recovery policy when it is due. True in the
    // one tick in which a re-arm is complete.
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
    std::optional<Taking> m_taken;  // how the operator took the authority; empty: the clients have it, or STOP took it
    bool m_stopLatched = false;
    bool m_closing = false;
    bool m_connected = false;
    bool m_wasConnected = false;
    SteadyTime m_quietUntil{};   // no motion before this time, right after a connection came back
    std::vector<Loss> m_losses;  // since the last re-arm; any of them latches the fault
    std::array<supervision::DriveConditions, 2> m_told{};  // the last known conditions of each drive
    bool m_rearming = false;
    SteadyTime m_now{};  // of the running or last tick
};

}  // namespace boresight
