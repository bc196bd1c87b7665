// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl that runs once per tick: judge what the drives say, then move on.
#include "core/moteus/faults.h"
#include "core/station/station_control.h"

#include <algorithm>

namespace boresight {
namespace {

// A late tick (a stalled machine) makes the mount slower, never jump.
constexpr Seconds kLongestStep{0.1};
constexpr Seconds kShutDownPatience{5.0};
constexpr Seconds kStall{0.125};
constexpr std::chrono::seconds kLimitLinger{2};
// How long the last order of the program is repeated, so that a lost frame does not matter.
constexpr std::chrono::milliseconds kLastOrder{150};
// A drive that boots, or a bus that comes up, is not yet a reason for an alarm.
constexpr std::chrono::seconds kPatienceAtStart{1};
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

QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

AlarmText silentText(const QString& drive)
{
    return {.what = QStringLiteral("No reply from the %1").arg(drive),
            .action = QStringLiteral("Nothing is commanded"),
            .remedy = QStringLiteral("Check the supply, the CAN cable, the adapter and the drive's id in the profile; "
                                     "boresightctl scan tells who answers")};
}

AlarmText lostText(const QString& drive, double watchdog)
{
    return {.what = QStringLiteral("No reply from the %1").arg(drive),
            .action = QStringLiteral("Motion ended; the drive stops itself by its watchdog (%1 s)").arg(watchdog),
            .remedy = QStringLiteral("Check the supply, the CAN cable and the adapter, then re-arm")};
}

AlarmText faultText(const QString& drive, int code)
{
    const moteus::FaultText fault = moteus::faultText(code);
    return {.what = QStringLiteral("%1 fault %2: %3").arg(drive).arg(code).arg(toQString(fault.meaning)),
            .action = QStringLiteral("The drive switched its output off; the other axis holds"),
            .remedy = toQString(fault.remedy) + QStringLiteral("; then re-arm")};
}

AlarmText timedOutText(const QString& drive)
{
    return {.what = QStringLiteral("The %1 timed out: it got no command in time").arg(drive),
            .action = QStringLiteral("It stopped itself by its watchdog; the other axis holds"),
            .remedy = QStringLiteral("Check the bus and the load of this computer, then re-arm")};
}

AlarmText releasedText(const QString& drive)
{
    return {.what = QStringLiteral("The %1 switched itself off").arg(drive),
            .action = QStringLiteral("Motion ended; the other axis holds"),
            .remedy = QStringLiteral("Its supply failed or another program stopped it: check both, then re-arm")};
}

AlarmText disobeysText(const QString& drive)
{
    return {.what = QStringLiteral("The %1 answers but does not do what it is told").arg(drive),
            .action = QStringLiteral("Nothing is commanded any more; the other axis holds"),
            .remedy = QStringLiteral("Look at its mode and fault; another program may command it; then re-arm")};
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
    for (const Axis axis : kAxes) {
        watchLoss(axis);
        watchSilence(axis);
        watchUnordered(axis);
        watchActiveLimit(axis);
    }
    watchJog();
    finishRearm();
    moveOn(step);
    shutDownFurther();
    return m_drives.frames();
}

void StationControl::watchConnection()
{
    const bool connected = m_drives.answering(m_now);
    if (connected == m_connected) {
        return;
    }
    m_connected = connected;
    if (connected) {
        m_log.add(Severity::Advisory, QStringLiteral("station"), QStringLiteral("both drives answer; nothing moves"));
        m_quietUntil = m_wasConnected ? m_now + kQuietAfterReturn : m_now;
        m_wasConnected = true;
    } else {
        m_log.add(Severity::Warning, QStringLiteral("station"), QStringLiteral("a drive has stopped answering"));
        holdHere(Activity::None);
    }
}

void StationControl::watchLoss(Axis axis)
{
    Drive& drive = m_drives.drive(axis);
    const auto loss = drive.takeLoss();
    if (!loss) {
        return;
    }
    const QString name = toQString(drive.name());
    AlarmText text;
    switch (*loss) {
        case DriveLoss::Silent:
            text = lostText(name, m_profile.control.watchdog.count());
            break;
        case DriveLoss::Fault:
            text = faultText(name, drive.report()->fault);
            break;
        case DriveLoss::TimedOut:
            text = timedOutText(name);
            break;
        case DriveLoss::Released:
            text = releasedText(name);
            break;
        case DriveLoss::Disobeys:
            text = disobeysText(name);
            break;
    }
    raiseAlarm(name, Severity::Alarm, text);
    m_interlock.latchFault(text.what);
    m_rearming = false;
    holdHere(Activity::None);
}

void StationControl::watchSilence(Axis axis)
{
    const Drive& drive = m_drives.drive(axis);
    const QString name = toQString(drive.name());
    if (!drive.answering(m_now)) {
        if (m_now - m_started > kPatienceAtStart && !m_alarms.active(name)) {
            raiseAlarm(name, Severity::Alarm, silentText(name));
        }
    } else if (!m_interlock.fault()) {
        clearAlarm(name);
    }
}

void StationControl::watchActiveLimit(Axis axis)
{
    const Drive& drive = m_drives.drive(axis);
    const QString name = toQString(drive.name());
    const QString cause = name + QStringLiteral(" limit");
    const auto& report = drive.report();
    auto& lastSeen = m_limitSeen[axis == Axis::Azimuth ? 0 : 1];
    if (report && report->mode == moteus::Mode::Position && moteus::isLimit(report->fault)) {
        lastSeen = m_now;
        const moteus::FaultText limit = moteus::faultText(report->fault);
        raiseAlarm(
            cause, Severity::Warning,
            {.what = QStringLiteral("%1 limit %2: %3").arg(name).arg(report->fault).arg(toQString(limit.meaning)),
             .action = QStringLiteral("The drive gives less than it was asked for"),
             .remedy = toQString(limit.remedy)});
    } else if (lastSeen && m_now - *lastSeen > kLimitLinger) {
        lastSeen.reset();
        clearAlarm(cause);
    }
}

void StationControl::watchUnordered(Axis axis)
{
    const Drive& drive = m_drives.drive(axis);
    const QString name = toQString(drive.name());
    const QString cause = name + QStringLiteral(" active");
    const bool ours = m_interlock.fault() || m_shutDown != ShutDown::No;  // what was ours may still run out
    if (drive.activeUnordered() && drive.answering(m_now) && !ours) {
        raiseAlarm(
            cause, Severity::Warning,
            {.what = QStringLiteral("%1 is active without our orders: mode %2")
                         .arg(name, toQString(moteus::modeText(drive.report()->mode))),
             .action = QStringLiteral("Boresight does not touch it before a command; STOP takes it over and holds"),
             .remedy = QStringLiteral("Another program, or an order left without a watchdog, drives it: end that")});
    } else {
        clearAlarm(cause);
    }
}

void StationControl::watchStall(Seconds gap)
{
    if (m_tick > 0 && gap > kStall) {
        m_drives.excuse(gap);
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

void StationControl::finishRearm()
{
    const auto busy = [&](Axis axis) {
        const Drive::Phase phase = m_drives.drive(axis).phase();
        return phase == Drive::Phase::Recovering || phase == Drive::Phase::Capturing;
    };
    if (!m_rearming || std::ranges::any_of(kAxes, busy)) {
        return;
    }
    m_rearming = false;
    m_interlock.clearFault();
    for (const Axis axis : kAxes) {
        clearAlarm(toQString(m_drives.drive(axis).name()));
    }
    m_log.add(Severity::Advisory, QStringLiteral("station"), QStringLiteral("re-armed; nothing moves"));
}

void StationControl::moveOn(Seconds step)
{
    for (const Axis axis : kAxes) {
        if (m_drives.drive(axis).takeEngaged()) {
            m_motion.start(axis, *m_drives.measured(axis));
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
    if (m_shutDown == ShutDown::Slowing && (m_motion.atRest() || m_now > m_shutDownDeadline)) {
        m_drives.leave(m_profile.control.onExit);
        m_shutDownDeadline = m_now + kLastOrder;
        m_shutDown = ShutDown::Leaving;
    } else if (m_shutDown == ShutDown::Leaving && m_now > m_shutDownDeadline) {
        m_shutDown = ShutDown::Done;
    }
}

}  // namespace boresight
