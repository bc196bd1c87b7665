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

// What a stall of this computer means for the drives: excuses them for what they could not answer, and takes over those
// that their own watchdogs have stopped. The motion was never cancelled, so it goes on. Station thread only. Angles are
// mechanical.
namespace boresight {

class StallGuard
{
public:
    StallGuard(DrivePair& drives, std::array<DriveWatch, 2>& watches, TurnKeeper& turns, AlarmBoard& alarms,
               EventLog& log)
        : m_drives(drives), m_watches(watches), m_turns(turns), m_alarms(alarms), m_log(log)
    {}

    // A tick begins `gap` after the one before. The drives were last commanded to `held`.
    void tickBegins(Seconds gap, Seconds watchdog, const AxisPosition& held, SteadyTime now);
    // The station has handed the frames of this tick to the link.
    void framesSent(Seconds watchdog, const AxisPosition& held, SteadyTime now);

    // How long this computer stalled, if that ended a moment ago.
    [[nodiscard]] std::optional<Seconds> recent(SteadyTime now) const { return m_stall.recent(now); }

    // Takes over the drives that timed out by a stall; `allowed`: nothing else stands in the way.
    void resume(bool allowed, SteadyTime now);
    // Once all drives are taken over and report where they stand, or when it is too late: the first axis that is not
    // back.
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
