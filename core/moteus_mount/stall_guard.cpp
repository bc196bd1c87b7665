// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/stall_guard.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/moteus_mount/drive_alarms.h"

#include <algorithm>

namespace boresight {
namespace {

// After a stall of this length the axes may be elsewhere.
constexpr Seconds kStall{0.125};
// Long enough for somebody to reach the switch of the mount. Settings that another tool changes meanwhile are found by
// the origin of the count.
constexpr Seconds kLongStall{2.0};

// Stopped by its watchdog and not for another reason.
bool isHealthy(const Drive& drive)
{
    return drive.report() && drive.report()->mode != moteus::Mode::Fault &&
           drive.loss().value_or(DriveLoss::TimedOut) == DriveLoss::TimedOut;
}

}  // namespace

void StallGuard::tickBegins(Seconds gap, Seconds watchdog, const AxisPosition& held, SteadyTime now)
{
    noticeSleep(now);
    if (m_stall.note(gap, watchdog, held, now)) {
        excuseDrives(now);
    }
}

void StallGuard::framesSent(Seconds watchdog, const AxisPosition& held, SteadyTime now)
{
    noticeSleep(now);
    if (m_stall.sent(watchdog, held, now)) {
        excuseDrives(now);
    }
}

void StallGuard::noticeSleep(SteadyTime now)
{
    if (m_sleep.sleptSince(m_clock) > Seconds(0.0)) {
        m_stall.woke(now);
    }
}

void StallGuard::excuseDrives(SteadyTime now)
{
    const Seconds gap = m_stall.gap();
    m_drives.excuse(gap, now);
    for (DriveWatch& watch : m_watches) {
        watch.forgetReplies();
    }
    if (gap <= kStall) {
        return;
    }
    for (const Axis axis : m_drives.axes()) {
        m_drives.drive(axis).expectAnotherPlace();
        m_watches[index(axis)].forgetMotion();
        if (gap > kLongStall) {
            m_turns.forget(axis);  // somebody may have worked on the drive meanwhile
        }
    }
    m_log.add(Severity::Warning, QStringLiteral("station"),
              Text::tr("this computer stalled for %1 s, and drives may have stopped by their watchdog")
                  .arg(gap.count(), 0, 'f', 2));
}

void StallGuard::resume(bool allowed, SteadyTime now)
{
    const auto mayGoOn = [this](Axis axis) { return isHealthy(m_drives.drive(axis)); };
    const bool resumes = allowed && m_stall.explainsTimeOut(now) && std::ranges::all_of(m_drives.axes(), mayGoOn);
    for (const Axis axis : m_drives.axes()) {
        Drive& drive = m_drives.drive(axis);
        if (resumes && drive.loss() == DriveLoss::TimedOut) {
            (void)drive.takeLoss();
            drive.engage();
            m_stall.resume(now);
            m_alarms.raise(alarmEntry("computer.stalled"), {QString::number(m_stall.gap().count(), 'f', 2)});
        }
    }
}

std::optional<std::pair<Axis, DriveWatch::Trouble>> StallGuard::finish(bool faultLatched, SteadyTime now)
{
    if (!m_stall.resuming() || (!m_drives.engaged() && !faultLatched && !m_stall.isLate(now))) {
        return std::nullopt;
    }
    m_stall.end();
    m_alarms.clear(alarmEntry("computer.stalled"));
    const auto isBack = [this](Axis axis) {
        const auto place = m_drives.measured(axis);
        return m_drives.drive(axis).phase() == Drive::Phase::Engaged && place && m_stall.isNear(axis, *place);
    };
    const AxisSet axes = m_drives.axes();
    const auto missing = std::ranges::find_if_not(axes, isBack);
    if (missing == axes.end() || faultLatched) {
        return std::nullopt;
    }
    const Drive& drive = m_drives.drive(*missing);
    const AlarmCase lost = drive_alarms::timedOutByStall(drive.label(), m_stall.gap());
    m_alarms.raise(lost.entry.of(*missing), lost.arguments);
    return std::pair(*missing, DriveWatch::Trouble{.what = whatOf(lost), .loss = supervision::LossClass::Bus});
}

}  // namespace boresight
