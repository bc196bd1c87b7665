// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl that runs once per tick: judge what the drives say, then move on.
#include "core/station/drive_alarms.h"
#include "core/station/station_control.h"

#include <algorithm>

namespace boresight {
namespace {

// A late tick (a stalled machine) makes the mount slower, never jump.
constexpr Seconds kLongestStep{0.1};
constexpr Seconds kShutDownPatience{5.0};
constexpr Seconds kStall{0.125};
// How long the last order of the program is repeated, so that a lost frame does not matter.
constexpr std::chrono::milliseconds kLastOrder{150};
// After a connection came back somebody may stand at the mast with a cable in the hand.
constexpr std::chrono::seconds kQuietAfterReturn{1};

// From full speed, with a second to spare.
Seconds longestStop(const profile::Profile& profile)
{
    const auto stop = [](const tracking::MotionLimits& limits) {
        return Seconds(limits.speed.radians() / limits.acceleration.radians() +
                       2.0 * limits.acceleration.radians() / limits.jerk.radians() + 1.0);
    };
    return std::max({kShutDownPatience, stop(profile.azimuth.limits), stop(profile.elevation.limits)});
}

}  // namespace

std::array<CanFrame, 2> StationControl::tick()
{
    const SteadyTime now = m_clock.now();
    watchStall(now - m_now);
    const Seconds step = std::clamp(Seconds(now - m_now), Seconds(0.0), kLongestStep);
    m_now = now;
    ++m_tick;
    m_drives.judge(now);
    watchConnection();
    keepTurns();
    watchDrives();
    watchJog();
    watchFitness();
    retry();
    finishRearm();
    stepProof();
    moveOn(step);
    shutDownFurther();
    return m_drives.frames();
}

void StationControl::watchConnection()
{
    const bool connected = m_drives.answering(m_now) && !m_released;
    if (connected == m_connected) {
        return;
    }
    m_connected = connected;
    if (connected) {
        m_log.add(Severity::Advisory, QStringLiteral("station"), QStringLiteral("both drives answer; nothing moves"));
        m_quietUntil = m_wasConnected ? m_now + kQuietAfterReturn : m_now;
        m_wasConnected = true;
    } else {
        m_log.add(Severity::Warning, QStringLiteral("station"),
                  m_released ? QStringLiteral("the bus is left to other tools")
                             : QStringLiteral("a drive has stopped answering"));
        holdHere(Activity::None);
    }
}

void StationControl::watchDrives()
{
    for (const Axis axis : kAxes) {
        const DriveWatch::Context context{.now = m_now,
                                          .running = m_now - m_started,
                                          .turnKnown = m_turns.known(axis),
                                          .faultLatched = faultLatched(),
                                          .ownOrders = faultLatched() || m_shutDown != ShutDown::No,
                                          .silenceExpected = m_released};
        const auto trouble = watchOf(axis).watch(m_drives.drive(axis), m_motion.setpoint(axis), context);
        if (trouble && trouble->stops) {
            stopFor(axis, *trouble);
        }
        if (trouble && trouble->turnDoubtful) {
            m_turns.forget(axis, trouble->what);
        }
    }
    if (!faultLatched()) {
        m_retry.healthy(m_now);
    }
}

// The motion ends, and the axis in trouble stays where it is: a target that it can not reach must not go on pulling.
void StationControl::stopFor(Axis axis, const DriveWatch::Trouble& trouble)
{
    m_losses.push_back({.axis = axis, .kind = trouble.loss, .conditions = conditions(axis)});
    m_interlock.latchFault(trouble.what);
    m_retry.lost(trouble.loss, m_now);
    m_rearming = false;
    holdHere(Activity::None);
    if (const auto measured = m_drives.measured(axis)) {
        m_motion.start(axis, *measured);
    }
}

void StationControl::keepTurns()
{
    for (const Axis axis : kAxes) {
        keepTurn(axis);
    }
    tellTurns();
}

void StationControl::keepTurn(Axis axis)
{
    Drive& drive = m_drives.drive(axis);
    const bool answering = drive.answering(m_now) && !m_released;
    if (!std::exchange(m_answered[index(axis)], answering) && answering) {
        m_turns.forget(axis);  // who was silent may come back as another
        watchOf(axis).forgetMotion();
    }
    if (answering && facts(axis)) {
        const bool before = m_turns.known(axis);
        m_turns.judge(axis, *facts(axis), drive, m_now);
        if (m_turns.known(axis) != before) {
            watchOf(axis).forgetMotion();  // what the drive reports may have leapt by whole turns
        }
        const bool moving = drive.phase() != Drive::Phase::Listening && !m_motion.atRest();
        m_turns.note(axis, *facts(axis), drive, moving, m_now);
    }
    letBackInside(axis);
}

// An axis that was pushed out beyond its drive's own bounds could not even be moved back: fault 39.
void StationControl::letBackInside(Axis axis)
{
    const auto measured = m_drives.measured(axis);
    const TravelRange& travel = m_model.axis(axis).travel;
    const Angle margin = m_profile.control.driveLimitMargin;
    bool& ignoring = m_ignoringBounds[index(axis)];
    const bool beyond = measured && (*measured < travel.min - margin || *measured > travel.max + margin);
    ignoring = m_turns.known(axis) && measured && (beyond || (ignoring && !travel.contains(*measured)));
    m_drives.drive(axis).setIgnoreBounds(ignoring);
}

void StationControl::tellTurns()
{
    const bool lost = std::exchange(m_turnsWereKnown, turnsKnown()) && !turnsKnown();
    if (lost) {
        holdHere(Activity::None);  // what was wanted is meant in a frame that is not true any more
    }
    for (const Axis axis : kAxes) {
        const QString name = drive_alarms::toQString(m_drives.drive(axis).name());
        const QString cause = name + QStringLiteral(" turn");
        if (m_turns.known(axis)) {
            m_alarms.clear(cause);
        } else if (((lost && !m_released) || turnQuestion(axis)) && !m_alarms.active(cause)) {
            m_alarms.raise(cause, Severity::Warning,
                           {.what = QStringLiteral("it is not known on which turn the axis of the %1 stands").arg(name),
                            .action = QStringLiteral("Pointing is refused, clients get no position; slow jogging only"),
                            .remedy = QStringLiteral("Look at the mount and its cable, then tell where it stands")});
        }
    }
}

void StationControl::watchStall(Seconds gap)
{
    if (m_tick > 0 && gap > kStall) {
        m_drives.excuse(gap, m_now + std::chrono::duration_cast<SteadyTime::duration>(gap));
        m_azimuthWatch.forgetMotion();
        m_elevationWatch.forgetMotion();
        m_log.add(Severity::Warning, QStringLiteral("station"),
                  QStringLiteral("this computer stalled for %1 s; drives may have stopped by their watchdog")
                      .arg(gap.count(), 0, 'f', 2));
    }
}

void StationControl::watchJog()
{
    if (m_jogDeadline && m_now > *m_jogDeadline) {
        m_log.add(Severity::Warning, m_commander.name, QStringLiteral("jog ends: its keep-alive did not come"));
        holdHere(Activity::Holding);
    }
}

// A drive that is not as it should be any more is not moved on.
void StationControl::watchFitness()
{
    if (!m_fitness && m_activity != Activity::None && m_activity != Activity::Holding && !m_motion.atRest()) {
        m_log.add(Severity::Warning, QStringLiteral("station"),
                  QStringLiteral("ends the motion: ") + QString::fromStdString(m_fitness.error().text));
        holdHere(Activity::Holding);
    }
}

supervision::DriveConditions StationControl::conditions(Axis axis) const
{
    const auto& report = m_drives.drive(axis).report();
    if (!report) {
        return {};
    }
    return {
        .voltage = report->voltage,
        .boardTemperature = report->boardTemperature,
        .motorTemperature = report->motorTemperature != 0.0 ? std::optional(report->motorTemperature) : std::nullopt};
}

// The heat or the supply that led to a fault is still there.
QString StationControl::rearmObstacle() const
{
    for (const Loss& loss : m_losses) {
        const QString why =
            supervision::clearRefusal(m_profile.supervision, loss.kind, loss.conditions, conditions(loss.axis));
        if (!why.isEmpty()) {
            return QStringLiteral("%1: %2").arg(drive_alarms::toQString(m_drives.drive(loss.axis).name()), why);
        }
    }
    return {};
}

void StationControl::beginRearm()
{
    for (const Axis axis : kAxes) {
        if (m_drives.drive(axis).latched()) {
            m_drives.drive(axis).recover();
        }
    }
    m_rearming = true;
}

void StationControl::finishRearm()
{
    if (!m_rearming || m_drives.changingHands()) {
        return;
    }
    m_rearming = false;
    m_interlock.clearFault();
    m_losses.clear();
    for (const Axis axis : kAxes) {
        m_alarms.clear(drive_alarms::toQString(m_drives.drive(axis).name()));
        watchOf(axis).rearmed();
    }
    m_log.add(Severity::Advisory, QStringLiteral("station"), QStringLiteral("re-armed; nothing moves"));
}

// The profile's written policy for a station without an operator: a re-arm, never a motion.
void StationControl::retry()
{
    const auto due = m_retry.nextTry();
    if (!due || m_now < *due || m_rearming || !faultLatched() || m_interlock.stopLatched() || !m_connected ||
        m_shutDown != ShutDown::No || m_now < m_quietUntil || !rearmObstacle().isEmpty()) {
        return;
    }
    m_retry.tried(m_now);
    m_log.add(Severity::Warning, QStringLiteral("station"),
              QStringLiteral("re-arms by the profile's recovery policy; nothing moves by itself"));
    beginRearm();
}

void StationControl::moveOn(Seconds step)
{
    for (const Axis axis : kAxes) {
        if (m_drives.drive(axis).takeEngaged()) {
            m_motion.start(axis, *m_drives.measured(axis));
            watchOf(axis).engaged();
        }
    }
    if (m_drives.engaged()) {
        m_motion.advance(m_now, step);
    } else {
        m_motion.brake(step);  // one axis alone goes nowhere
    }
    for (const Axis axis : kAxes) {
        const tracking::Setpoint& setpoint = m_motion.setpoint(axis);
        m_drives.setSetpoint(axis, setpoint.position, setpoint.rate);
    }
}

void StationControl::shutDown()
{
    if (m_shutDown == ShutDown::No) {
        m_shutDown = ShutDown::Slowing;
        m_shutDownDeadline = m_clock.now() + std::chrono::ceil<std::chrono::milliseconds>(longestStop(m_profile));
        holdHere(Activity::None);
    }
}

void StationControl::shutDownFurther()
{
    const bool still = m_motion.atRest() && !m_drives.changingHands();
    if (m_shutDown == ShutDown::Slowing && (still || m_now > m_shutDownDeadline)) {
        m_drives.leave(m_profile.control.onExit);
        m_shutDownDeadline = m_now + kLastOrder;
        m_shutDown = ShutDown::Leaving;
    } else if (m_shutDown == ShutDown::Leaving && m_now > m_shutDownDeadline) {
        m_shutDown = ShutDown::Done;
    }
}

}  // namespace boresight
