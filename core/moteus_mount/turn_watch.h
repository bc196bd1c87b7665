// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/base/clock.h"
#include "core/drive_check/drive_check.h"
#include "core/moteus_mount/drive_pair.h"
#include "core/moteus_mount/drive_watch.h"
#include "core/moteus_mount/turn_keeper.h"

#include <algorithm>
#include <array>
#include <optional>

// Keeps the wraps of the axes up to date. Passes what the drive check knows of each drive to the TurnKeeper, forgets
// the wrap of a drive that was silent, and raises the alarms while a wrap is unknown. Station thread only.
namespace boresight {

class TurnWatch
{
public:
    TurnWatch(TurnKeeper& turns, DrivePair& drives, std::array<DriveWatch, 2>& watches, AlarmBoard& alarms)
        : m_turns(turns), m_drives(drives), m_watches(watches), m_alarms(alarms)
    {}

    // The facts that the drive check has about a drive. Empty: none, and the wrap is then judged again later.
    void learn(Axis axis, const std::optional<drive_check::DriveFacts>& facts) { m_facts[index(axis)] = facts; }
    [[nodiscard]] const std::optional<drive_check::DriveFacts>& facts(Axis axis) const { return m_facts[index(axis)]; }
    // The origin of the drive's count must be read again.
    [[nodiscard]] bool needsOrigin(Axis axis) const;
    // The drive was power-cycled while we watched it, or may be another drive.
    void forget(Axis axis);

    struct Tick
    {
        SteadyTime now;
        bool released = false;  // the bus is left to other tools
        bool atRest = false;    // all set-points stand still
    };
    // Once in a tick, after the replies were judged. True once when a wrap that was known has become unknown.
    [[nodiscard]] bool keep(const Tick& tick);
    // Call it after keep(). `interrupted`: a motion ended because of this. `readable`: the reports of the drives can be
    // used.
    void raiseAlarms(bool interrupted, bool readable);
    [[nodiscard]] bool allKnown() const
    {
        return std::ranges::all_of(m_drives.axes(), [this](Axis axis) { return m_turns.known(axis); });
    }

private:
    void keep(Axis axis, const Tick& tick);
    void raisePlaceAlarm(Axis axis);

    TurnKeeper& m_turns;
    DrivePair& m_drives;
    std::array<DriveWatch, 2>& m_watches;
    AlarmBoard& m_alarms;
    std::array<std::optional<drive_check::DriveFacts>, 2> m_facts;
    std::array<bool, 2> m_answered{};
    bool m_wereKnown = false;
};

}  // namespace boresight
