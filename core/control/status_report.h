// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/axes/drive_pair.h"
#include "core/axes/motion.h"
#include "core/axes/turn_keeper.h"
#include "core/control/arming.h"
#include "core/control/cable_guard.h"
#include "core/control/current_motion.h"
#include "core/control/proof_run.h"
#include "core/control/sun_watch.h"
#include "core/control/turn_watch.h"
#include "core/messages/station_status.h"
#include "core/pointing/mount_model.h"

#include <optional>

// What the control knows, as the world sees it: the state of the mount and of its axes, in values and words. Made anew
// from the parts each time that it is asked for; decides nothing. Station thread only.
namespace boresight {

class StatusReport
{
public:
    struct Parts
    {
        const profile::Profile& profile;
        const Clock& clock;
        const pointing::MountModel& model;
        const DrivePair& drives;
        const Motion& motion;
        const CurrentMotion& current;
        const Arming& arming;
        const TurnKeeper& turns;
        const TurnWatch& facts;
        const ProofRun& proof;
        const CableGuard& cable;
        const SunWatch& sun;
        const AlarmBoard& alarms;
        SteadyTime now;  // of the running or last tick
        std::uint64_t tick = 0;
    };

    explicit StatusReport(const Parts& parts) : m_of(parts) {}

    [[nodiscard]] StationState state() const;
    [[nodiscard]] StationStatus status() const;
    // What the last tick commanded and what the drives have answered to it; empty before the first tick.
    [[nodiscard]] std::optional<TickSample> sample() const;
    // Both axes are this near to where they are sent.
    [[nodiscard]] bool onTarget(Angle within) const;
    [[nodiscard]] bool arrived() const;  // at the place or direction that was asked for, and at rest there
    // Why not the target is driven but the nearest permitted place; empty: it is driven.
    [[nodiscard]] QString limitedReason() const;

private:
    [[nodiscard]] AxisStatus axisStatus(Axis axis) const;
    [[nodiscard]] AxisSample axisSample(Axis axis) const;
    [[nodiscard]] AxisState axisState(Axis axis) const;
    [[nodiscard]] AxisState ownState(Axis axis) const;
    [[nodiscard]] QString axisText(Axis axis, AxisState state) const;
    [[nodiscard]] bool atTravelEnd(Axis axis) const;
    [[nodiscard]] bool atLimit(Axis axis) const;
    [[nodiscard]] DrivesStatus drivesStatus() const;
    [[nodiscard]] DriveStatus driveStatus(Axis axis) const;

    Parts m_of;
};

}  // namespace boresight
