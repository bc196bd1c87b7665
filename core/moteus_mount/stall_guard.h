// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/moteus_mount/drive_pair.h"
#include "core/moteus_mount/drive_watch.h"
#include "core/moteus_mount/own_stall.h"
#include "core/moteus_mount/turn_keeper.h"

#include <array>
#include <optional>
#include <utility>

// Handles the effect of a stall of this computer on the drives. Excuses the drives for replies that they could not
// give, and captures the drives again that their own watchdogs stopped. The motion was not cancelled, so it continues.
// Station thread only. Mechanical angles.
namespace boresight {

class StallGuard
{
public:
    StallGuard(DrivePair& drives, std::array<DriveWatch, 2>& watches, TurnKeeper& turns, AlarmBoard& alarms,
               EventLog& log)
        : m_drives(drives), m_watches(watches), m_turns(turns), m_alarms(alarms), m_log(log)
    {}

    // A tick begins `gap` after the previous tick. The drives were last commanded to `held`.
    void tickBegins(Seconds gap, Seconds watchdog, const AxisPosition& held, SteadyTime now);
    // The station has handed the frames of this tick to the link.
    void framesSent(Seconds watchdog, const AxisPosition& held, SteadyTime now);

    // How long this computer stalled, if the stall ended a moment ago.
    [[nodiscard]] std::optional<Seconds> recent(SteadyTime now) const { return m_stall.recent(now); }

    // Captures the drives that timed out because of a stall. `allowed`: nothing else is in the way.
    void resume(bool allowed, SteadyTime now);
    // Ends the resumption once all drives are captured again, or once its time has passed. Returns the first axis that
    // is not back near its set-point then.
    [[nodiscard]] std::optional<std::pair<Axis, DriveWatch::Trouble>> finish(bool faultLatched, SteadyTime now);

private:
    void excuseDrives(SteadyTime now);

    DrivePair& m_drives;
    std::array<DriveWatch, 2>& m_watches;
    TurnKeeper& m_turns;
    AlarmBoard& m_alarms;
    EventLog& m_log;
    OwnStall m_stall;
};

}  // namespace boresight
