// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/turn_watch.h"

#include "core/alarms/catalogue.h"

#include <utility>

namespace boresight {

bool TurnWatch::needsOrigin(Axis axis) const
{
    return facts(axis) && m_turns.needsOrigin(axis, *facts(axis));
}

void TurnWatch::forget(Axis axis)
{
    m_turns.forget(axis);
    m_drives.drive(axis).forgetPlace();
    m_watches[index(axis)].forgetMotion();
}

bool TurnWatch::keep(const Tick& tick)
{
    for (const Axis axis : m_drives.axes()) {
        keep(axis, tick);
    }
    return std::exchange(m_wereKnown, allKnown()) && !allKnown();
}

void TurnWatch::keep(Axis axis, const Tick& tick)
{
    Drive& drive = m_drives.drive(axis);
    const bool answering = drive.answering(tick.now) && !tick.released;
    if (!std::exchange(m_answered[index(axis)], answering) && answering) {
        forget(axis);  // a drive that was silent may be another board when it returns
    }
    if (answering && facts(axis) && !drive.jumped()) {
        const bool before = m_turns.known(axis);
        m_turns.judge(axis, *facts(axis), drive, tick.now);
        if (m_turns.known(axis) != before) {
            m_watches[index(axis)].forgetMotion();  // the reported position may have changed by whole turns
        }
        const bool moving = drive.phase() != Drive::Phase::Listening && !tick.atRest;
        m_turns.note(axis, *facts(axis), drive, moving, tick.now);
    }
}

void TurnWatch::raiseAlarms(bool interrupted, bool readable)
{
    for (const Axis axis : m_drives.axes()) {
        const Drive& drive = m_drives.drive(axis);
        // The elevation has no cable.
        const AlarmEntry& entry =
            axis == Axis::Azimuth ? alarmEntry("drive.wrap-unknown") : alarmEntry("drive.place-unknown");
        const AlarmKey unknown = entry.of(axis);
        if (m_turns.known(axis)) {
            m_alarms.clear(unknown);
        } else if ((interrupted || (readable && m_turns.question(axis, drive))) && !m_alarms.active(unknown)) {
            // If nothing moved, the alarm waits, because the drive check may answer the question first.
            m_alarms.raise(unknown, {drive.label()});
        }
        raisePlaceAlarm(axis);
    }
}

// This alarm exists because a service has no window that asks.
void TurnWatch::raisePlaceAlarm(Axis axis)
{
    const Drive& drive = m_drives.drive(axis);
    const AlarmKey unused = alarmEntry("drive.place-unused").of(axis);
    const QString& problem = m_turns.placeProblem(axis);
    if (m_turns.known(axis)) {
        m_alarms.clear(unused);
    } else if (!problem.isEmpty() && !m_alarms.active(unused)) {
        m_alarms.raise(unused, {drive.label(), problem});
    }
}

}  // namespace boresight
