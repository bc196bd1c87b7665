// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl that runs once per tick: judge what the drives say, then move on.
#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/control/station_control.h"

#include <algorithm>

namespace boresight {
namespace {

// A late tick (a stalled machine) makes the mount slower, never jump.
constexpr Seconds kLongestStep{0.1};

}  // namespace

std::array<CanFrame, 2> StationControl::tick()
{
    const SteadyTime now = m_clock.now();
    if (m_tick > 0) {
        m_stall.tickBegins(now - m_now, m_profile.control.watchdog, heldPlace(), now);
    }
    const Seconds step = std::clamp(Seconds(now - m_now), Seconds(0.0), kLongestStep);
    m_now = now;
    if (m_tick == 0) {
        m_started = now;  // the drives have had no question before
    }
    ++m_tick;
    m_drives.judge(now);
    if (m_arming.losesConnection(now)) {
        holdHere(Activity::None);
    }
    keepTurns();
    resumeAfterStall();
    watchDrives();
    letBackInside();
    keepStopped();
    watchJog();
    watchFirstMoves();
    watchFitness();
    finishRearm();
    if (m_proof.step(m_now, m_clock.utc())) {
        holdHere(Activity::Holding);
    }
    watchSun();
    moveOn(step);
    watchRegion();
    watchCable();
    watchLimited();
    m_alarms.tick();
    if (m_end.leaves(m_motion.atRest() && !m_drives.changingHands(), m_now)) {
        m_drives.leave(m_profile.control.onExit);
    }
    return m_drives.frames();
}

void StationControl::framesSent()
{
    m_stall.framesSent(m_profile.control.watchdog, heldPlace(), m_clock.now());
}

void StationControl::watchDrives()
{
    for (const Axis axis : kAxes) {
        const DriveWatch::Context context{.now = m_now,
                                          .running = m_now - m_started,
                                          .turnKnown = m_turns.known(axis),
                                          .faultLatched = faultLatched(),
                                          .ownOrders = m_arming.closing(),
                                          .silenceExpected = m_arming.released()};
        const auto trouble = watchOf(axis).watch(m_drives.drive(axis), m_motion.setpoint(axis), context);
        if (trouble && trouble->stops) {
            stopFor(axis, *trouble);
        }
        if (trouble && trouble->turnDoubtful) {
            m_turns.forget(axis, trouble->what);
        }
    }
}

// Behind a latched STOP nothing is moved by others' orders either, nor by a drive that comes back with them.
void StationControl::keepStopped()
{
    if (m_arming.stopLatched() && !m_arming.released() && !m_arming.closing()) {
        m_drives.seize(m_now);
    }
}

// The motion ends: the axes brake from their set-points. One that can not follow stays where it is, so that its
// set-point does not go on pulling. One whose angle has jumped gets no set-point at all, because nobody knows which of
// the two places its drive would take it to mean.
void StationControl::stopFor(Axis axis, const DriveWatch::Trouble& trouble)
{
    m_arming.lost(axis, trouble.loss, trouble.what);
    holdHere(Activity::None);
    if (trouble.turnDoubtful) {
        m_drives.drive(axis).hold();
    } else if (trouble.gaveWay) {
        m_drives.drive(axis).yield();  // its set-point follows when the drive is captured
    }
}

void StationControl::keepTurns()
{
    const bool lost = m_turnWatch.keep({.now = m_now, .released = m_arming.released(), .atRest = m_motion.atRest()});
    const bool interrupted = lost && !m_current.is(Activity::None);
    if (lost) {
        holdHere(Activity::None);  // what was wanted is meant in a frame that is not true any more
    }
    m_turnWatch.raiseAlarms(interrupted, m_arming.drivesReadable());
}

// An axis that was pushed out beyond its drive's own bounds could not even be moved back: fault 39.
void StationControl::letBackInside()
{
    const Gates gates = this->gates();
    for (const Axis axis : kAxes) {
        const auto measured = m_drives.measured(axis);
        const bool outside = m_turns.known(axis) && measured && !m_model.axis(axis).travel.contains(*measured);
        bool& ignoring = m_ignoringBounds[index(axis)];
        ignoring = gates.farOutside(axis) != 0 || (ignoring && outside);
        m_drives.drive(axis).setIgnoreBounds(ignoring);
    }
}

// Where the drives were told to be; one that is still taken over has no set-point.
AxisPosition StationControl::heldPlace() const
{
    const auto of = [this](Axis axis, Angle setpoint) {
        const bool engaged = m_drives.drive(axis).phase() == Drive::Phase::Engaged;
        return engaged ? setpoint : m_drives.measured(axis).value_or(setpoint);
    };
    const AxisPosition told = m_motion.place();
    return {.azimuth = of(Axis::Azimuth, told.azimuth), .elevation = of(Axis::Elevation, told.elevation)};
}

// Where a drive does not come back the motion ends.
void StationControl::resumeAfterStall()
{
    const bool hindered = m_proof.running() || m_arming.closing() || m_arming.released() || m_arming.stopLatched() ||
                          faultLatched() || !m_arming.fitness() || !turnsKnown();
    m_stall.resume(m_profile.control.afterStall == profile::AfterStall::Resume && !hindered, m_now);
    if (const auto missing = m_stall.finish(faultLatched(), m_now)) {
        stopFor(missing->first, missing->second);
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
    if (!m_arming.fitness() && moves() && !m_motion.atRest()) {
        m_log.add(Severity::Warning, QStringLiteral("station"),
                  Text::tr("ends the motion: %1").arg(toQString(m_arming.fitness().error().text)));
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
    for (const Axis axis : kAxes) {
        m_alarms.clear(alarmEntry("drive.fault").of(axis));
        watchOf(axis).rearmed();
    }
    m_log.add(Severity::Advisory, QStringLiteral("station"), Text::tr("re-armed; nothing moves"));
}

void StationControl::moveOn(Seconds step)
{
    for (const Axis axis : kAxes) {
        if (m_drives.drive(axis).takeEngaged()) {
            m_motion.start(axis, *m_drives.measured(axis));
            watchOf(axis).engaged();
        }
    }
    m_motion.enforceRegion(turnsKnown());
    m_motion.setHardBraking(m_arming.stopLatched());
    m_drives.setHardBraking(m_arming.stopLatched());
    if (m_drives.engaged() && m_drives.seen()) {
        m_motion.advance(m_now, step);
    } else {
        m_motion.brake(step);  // one axis alone goes nowhere, nor does one that nobody sees
    }
    for (const Axis axis : kAxes) {
        const tracking::Setpoint& setpoint = m_motion.setpoint(axis);
        m_drives.setSetpoint(axis, setpoint.position, setpoint.rate);
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
