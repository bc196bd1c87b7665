// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/silence_alarms.h"

#include "core/alarms/catalogue.h"
#include "core/moteus_mount/drive_alarms.h"

#include <algorithm>

namespace boresight {
namespace {

// When a bus fails, the last replies of the two drives are some ticks apart. So are the first replies when it returns.
constexpr std::chrono::milliseconds kTogether{300};
// This many lost ticks in a row mean that the bus failed. By chance fewer are lost.
constexpr auto kQuiet = Drive::kSilence / 2;

AlarmCase caseOf(const Silence& silence, const QString& drive, Seconds watchdog, const QString& advice)
{
    switch (silence.kind) {
        case Silence::Kind::Lost:
            return drive_alarms::silenced(drive, watchdog, advice);
        case Silence::Kind::Unheard:
            return drive_alarms::unheard(drive, advice, silence.needsRearm);
        case Silence::Kind::Back:
            break;
    }
    return drive_alarms::answersAgain(drive, silence.lasted, silence.moved);
}

AlarmCase caseOfBoth(const Silence& azimuth, const Silence& elevation, Seconds watchdog, const QString& advice)
{
    switch (azimuth.kind) {
        case Silence::Kind::Lost:
            return drive_alarms::bothSilenced(watchdog, advice);
        case Silence::Kind::Unheard:
            return drive_alarms::noneHeard(advice, azimuth.needsRearm);
        case Silence::Kind::Back:
            break;
    }
    return drive_alarms::bothAnswerAgain(std::max(azimuth.lasted, elevation.lasted), azimuth.moved, elevation.moved);
}

}  // namespace

void SilenceAlarms::tell(Axis axis, const Silence& silence)
{
    m_silences[index(axis)] = silence;
    m_isNew[index(axis)] = true;
}

void SilenceAlarms::show(SteadyTime now)
{
    const bool before = m_together;
    m_together = belongTogether(now);
    if (m_together != before) {
        m_isNew.fill(true);
    }
    if (m_together) {
        showBoth();
    } else {
        showEach();
    }
    m_isNew.fill(m_parted.has_value());
}

bool SilenceAlarms::isQuiet(Axis axis, SteadyTime now) const
{
    return now - m_drives.drive(axis).heard() >= kQuiet;
}

bool SilenceAlarms::belongTogether(SteadyTime now)
{
    const auto& [azimuth, elevation] = m_silences;
    const bool pair = m_drives.axes().size() == kAxes.size();
    if (!pair || (!azimuth && !elevation)) {
        m_parted.reset();
        return false;
    }
    if (azimuth && elevation && azimuth->kind == elevation->kind) {
        m_parted.reset();
        return std::chrono::abs(azimuth->since - elevation->since) < kTogether;
    }
    if (m_together) {
        m_parted = m_parted.value_or(now);
        return now - *m_parted < kTogether;
    }
    m_parted.reset();
    // The other drive will be reported missing within a few ticks.
    return (azimuth && !elevation && azimuth->kind == Silence::Kind::Lost && isQuiet(Axis::Elevation, now)) ||
           (elevation && !azimuth && elevation->kind == Silence::Kind::Lost && isQuiet(Axis::Azimuth, now));
}

// While the two differ for a moment, the alarm about both stays as it is.
void SilenceAlarms::showBoth()
{
    for (const Axis axis : kAxes) {
        m_alarms.clear(alarmEntry("drive.silent").of(axis));
    }
    const bool isNew = std::ranges::any_of(m_isNew, [](bool one) { return one; });
    if (!isNew || m_parted) {
        return;
    }
    const auto& [azimuth, elevation] = m_silences;
    const AlarmCase alarm =
        caseOfBoth(azimuth.value_or(elevation.value_or(Silence{})), elevation.value_or(azimuth.value_or(Silence{})),
                   m_profile->control.watchdog, m_advice);
    m_alarms.raise(alarm.entry, alarm.arguments);
}

void SilenceAlarms::showEach()
{
    m_alarms.clear(alarmEntry("drives.silent"));
    for (const Axis axis : m_drives.axes()) {
        const auto& silence = m_silences[index(axis)];
        if (!silence) {
            m_alarms.clear(alarmEntry("drive.silent").of(axis));
        } else if (m_isNew[index(axis)]) {
            const AlarmCase alarm =
                caseOf(*silence, m_drives.drive(axis).label(), m_profile->control.watchdog, m_advice);
            m_alarms.raise(alarm.entry.of(axis), alarm.arguments);
        }
    }
}

}  // namespace boresight
