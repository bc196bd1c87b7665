// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl that runs once per tick: judge what the drives say, then move on.
#include "core/base/text.h"
#include "core/control/station_control.h"
#include "core/mount/mount_service.h"

#include <algorithm>

namespace boresight {
namespace {

// A late tick (a stalled machine) makes the mount slower, never jump.
constexpr Seconds kLongestStep{0.1};

}  // namespace

void StationControl::tick()
{
    const SteadyTime now = m_clock.now();
    const Seconds step = std::clamp(Seconds(now - m_now), Seconds(0.0), kLongestStep);
    m_now = now;
    ++m_tick;
    m_mount.observe(now);
    if (m_arming.losesConnection(now)) {
        holdHere(Activity::None);
    }
    superviseMount();
    keepStopped();
    watchJog();
    watchFirstMoves();
    watchFitness();
    finishRearm();
    stepProof();
    watchSun();
    moveOn(step);
    watchRegion();
    watchCable();
    watchLimited();
    m_alarms.tick();
    if (m_end.leaves(m_motion.atRest() && !m_mount.changesHands(), m_now)) {
        m_mount.leave(m_profile.control.onExit);
    }
}

// The motion ends with a trouble: the axes brake from their set-points.
void StationControl::superviseMount()
{
    const MountFindings found = m_mount.supervise({.moves = !m_current.is(Activity::None),
                                                   .settled = m_motion.atRest(),
                                                   .faultLatched = faultLatched(),
                                                   .stopLatched = m_arming.stopLatched(),
                                                   .closing = m_arming.closing()});
    if (found.interrupted) {
        holdHere(Activity::None);
    }
    for (const AxisTrouble& trouble : found.troubles) {
        m_arming.lost(trouble.axis, trouble.loss, trouble.what);
        holdHere(Activity::None);
    }
}

// Behind a latched STOP nothing is moved by others' orders either, nor by a drive that comes back with them.
void StationControl::keepStopped()
{
    if (m_arming.stopLatched() && m_mount.available() && !m_arming.closing()) {
        m_mount.seize();
    }
}

void StationControl::stepProof()
{
    if (!m_mount.proofRunning()) {
        return;
    }
    const MountService::ProofStep step = m_mount.service()->stepProof();
    if (step.run) {
        m_motion.run(*step.run);
    }
    if (step.rest) {
        m_motion.rest();
    }
    if (step.ended) {
        holdHere(Activity::Holding);
    }
}

void StationControl::watchJog()
{
    if (m_current.keepAliveMissed(m_now)) {
        m_log.add(Severity::Warning, m_current.commander().name, Text::tr("jog ends: its keep-alive did not come"));
        holdHere(Activity::Holding);
    }
}

void StationControl::watchCable()
{
    const auto path = m_current.is(Activity::Streaming) && turnsKnown() ? m_motion.path(m_now) : std::nullopt;
    const auto target = moves() && m_motion.noWay().empty() ? m_motion.target(m_now) : std::nullopt;
    const auto left = target ? std::optional(target->azimuth - m_motion.place().azimuth) : std::nullopt;
    m_cable.watch(path, left, m_motion.region().ranges().azimuth, m_profile.azimuth.limits);
}

// A drive that is not as it should be any more is not moved on.
void StationControl::watchFitness()
{
    if (!m_mount.fitness() && moves() && !m_motion.atRest()) {
        m_log.add(Severity::Warning, QStringLiteral("station"),
                  Text::tr("ends the motion: %1").arg(toQString(m_mount.fitness().error().text)));
        holdHere(Activity::Holding);
    }
}

// Tells what holds a motion, and ends one that has no way left: the region was drawn anew. A stream of a client waits.
void StationControl::watchRegion()
{
    if (m_current.goesToAPlace() && !m_motion.noWay().empty()) {
        m_log.add(Severity::Warning, QStringLiteral("station"),
                  Text::tr("ends the motion: %1").arg(toQString(m_motion.noWay())));
        holdHere(Activity::Holding);
    }
    const bool held = m_motion.held(Axis::Azimuth) || m_motion.held(Axis::Elevation);
    const std::string at = held ? Text::tr("held at %1").arg(toQString(m_motion.obstacle())).toStdString()
                           : m_motion.noWay().empty()
                               ? ""
                               : Text::tr("held: %1").arg(toQString(m_motion.noWay())).toStdString();
    const bool pressed = m_current.runsFreely() || (m_current.is(Activity::Streaming) && !m_motion.noWay().empty());
    if (pressed && !at.empty() && at != m_heldAt) {
        tell(Severity::Warning, m_current.commander(), QString::fromStdString(at));
    }
    m_heldAt = pressed ? at : std::string();
}

void StationControl::finishRearm()
{
    if (!m_arming.completesRearm()) {
        return;
    }
    m_mount.rearmed();
    m_log.add(Severity::Advisory, QStringLiteral("station"), Text::tr("re-armed; nothing moves"));
}

void StationControl::moveOn(Seconds step)
{
    for (const Axis axis : kAxes) {
        if (const auto place = m_mount.takeFollowing(axis)) {
            m_motion.start(axis, *place);
        }
    }
    m_motion.enforceRegion(turnsKnown());
    m_motion.setHardBraking(m_arming.stopLatched());
    m_mount.brakeHard(m_arming.stopLatched());
    if (m_mount.follows() && m_mount.seen()) {
        m_motion.advance(m_now, step);
    } else {
        m_motion.brake(step);  // one axis alone goes nowhere, nor does one that nobody sees
    }
    for (const Axis axis : kAxes) {
        m_mount.command(axis, m_motion.setpoint(axis));
    }
}

void StationControl::shutDown()
{
    if (m_end.begin(m_profile, m_clock.now())) {
        m_arming.close();
        holdHere(Activity::None);
    }
}

}  // namespace boresight
