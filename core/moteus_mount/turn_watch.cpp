// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/turn_watch.h"

#include "core/base/text.h"

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
    for (const Axis axis : kAxes) {
        keep(axis, tick);
    }
    return std::exchange(m_wereKnown, allKnown()) && !allKnown();
}

void TurnWatch::keep(Axis axis, const Tick& tick)
{
    Drive& drive = m_drives.drive(axis);
    const bool answering = drive.answering(tick.now) && !tick.released;
    if (!std::exchange(m_answered[index(axis)], answering) && answering) {
        forget(axis);  // who was silent may come back as another
    }
    if (answering && facts(axis) && !drive.jumped()) {
        const bool before = m_turns.known(axis);
        m_turns.judge(axis, *facts(axis), drive, tick.now);
        if (m_turns.known(axis) != before) {
            m_watches[index(axis)].forgetMotion();  // what the drive reports may have leapt by whole turns
        }
        const bool moving = drive.phase() != Drive::Phase::Listening && !tick.atRest;
        m_turns.note(axis, *facts(axis), drive, moving, tick.now);
    }
}

void TurnWatch::raiseAlarms(bool interrupted, bool readable)
{
    for (const Axis axis : kAxes) {
        const Drive& drive = m_drives.drive(axis);
        const QString cause = toQString(drive.name()) + QStringLiteral(" turn");
        if (m_turns.known(axis)) {
            m_alarms.clear(cause);
        } else if ((interrupted || (readable && m_turns.question(axis, drive))) && !m_alarms.active(cause)) {
            // Where nothing moved, the survey may answer it first.
            m_alarms.raise(
                cause, Severity::Warning,
                {.what = Text::tr("it is not known on which turn the axis of the %1 stands").arg(drive.label()),
                 .action = Text::tr("Pointing is refused, clients get no position; slow jogging only"),
                 .remedy = Text::tr("Look at the mount and its cable, then tell where it stands")});
        }
        raisePlaceAlarm(axis);
    }
}

// A service has no window that asks.
void TurnWatch::raisePlaceAlarm(Axis axis)
{
    const Drive& drive = m_drives.drive(axis);
    const QString cause = toQString(drive.name()) + QStringLiteral(" place");
    const QString& problem = m_turns.placeProblem(axis);
    if (m_turns.known(axis)) {
        m_alarms.clear(cause);
    } else if (!problem.isEmpty() && !m_alarms.active(cause)) {
        m_alarms.raise(cause, Severity::Warning,
                       {.what = Text::tr("--standing-at was not used for the %1: %2").arg(drive.label(), problem),
                        .action = Text::tr("The cable wrap stays unknown"),
                        .remedy = Text::tr("Enter the place in the window, or start again with the present place "
                                           "and time")});
    }
}

}  // namespace boresight
