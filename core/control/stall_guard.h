// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/axes/drive_pair.h"
#include "core/axes/drive_watch.h"
#include "core/axes/turn_keeper.h"
#include "core/control/own_stall.h"

#include <array>
#include <optional>
#include <utility>

// What a stall of this computer means for the drives: excuses them for what they could not answer, and takes over those
// that their own watchdogs have stopped. What was wanted of them was never given up, so it goes on by itself. Station
// thread only; mechanical angles.
namespace boresight {

class StallGuard
{
public:
    StallGuard(DrivePair& drives, std::array<DriveWatch, 2>& watches, TurnKeeper& turns, AlarmBoard& alarms,
               EventLog& log)
        : m_drives(drives), m_watches(watches), m_turns(turns), m_alarms(alarms), m_log(log)
    {}

    // A tick begins `gap` after the one before; the drives were told to be at `held`.
    void tickBegins(Seconds gap, Seconds watchdog, const AxisPosition& held, SteadyTime now);
    void framesSent(Seconds watchdog, const AxisPosition& held, SteadyTime now) { m_stall.sent(watchdog, held, now); }

    // Takes over the drives that timed out by a stall; `allowed`: nothing else stands in the way.
    void resume(bool allowed, SteadyTime now);
    // Both drives are taken over and report where they stand, or it is too late. Then the first that is not back.
    [[nodiscard]] std::optional<std::pair<Axis, DriveWatch::Trouble>> finish(bool faultLatched, Seconds watchdog,
                                                                             SteadyTime now);

private:
    DrivePair& m_drives;
    std::array<DriveWatch, 2>& m_watches;
    TurnKeeper& m_turns;
    AlarmBoard& m_alarms;
    EventLog& m_log;
    OwnStall m_stall;
};

}  // namespace boresight
