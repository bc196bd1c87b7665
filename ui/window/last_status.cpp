// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/last_status.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/messages/no_data.h"
#include "ui/kit/format.h"

#include <memory>
#include <utility>

namespace boresight::ui {

namespace {

constexpr std::chrono::seconds kStopUnanswered{1};

// Refuses the actions that would use the last reported position.
void refuseOldPlaces(Permissions& may)
{
    const QString why = Text::tr("no fresh position from the %1");
    may.refuse(Action::SetAzimuth, why.arg(Text::of("azimuth drive")));
    may.refuse(Action::SetElevation, why.arg(Text::of("elevation drive")));
    may.refuse(Action::TakeKnownPoint, why.arg(Text::of("azimuth drive")));
}

// This alarm ends by itself. The station has nothing to acknowledge.
void complain(StationStatus& status, const AlarmEntry& entry, const QStringList& arguments = {})
{
    const AlarmText text = textOf(entry, arguments);
    const Alarm alarm{.name = QLatin1String(entry.id),
                      .severity = entry.severity,
                      .what = text.what,
                      .action = text.action,
                      .remedy = text.remedy,
                      .since = computerUtc(status),
                      .acknowledged = true};
    status.alarms.insert(status.alarms.begin(), alarm);
}

// It is unknown whether this work still goes on.
void hideWork(StationStatus& status)
{
    status.power.total.reset();
    status.power.running.reset();
    if (status.drives) {
        status.drives->boardWork = {};
        status.drives->gearWork = {};
    }
    if (status.tuning->running) {
        auto ended = std::make_shared<TuningStatus>(*status.tuning);
        ended->running.reset();
        status.tuning = std::move(ended);
    }
}

}  // namespace

LastStatus::LastStatus(const Clock& clock) : m_clock(clock), m_taken(clock.now())
{
    m_received.drives.emplace();  // their page is shown until the station reports a mount without drives of that kind
}

void LastStatus::take(const StationStatus& status)
{
    m_received = status;
    m_taken = m_clock.now();
    if (status.stopLatched) {
        m_stopSince.reset();
    }
}

void LastStatus::stopAsked()
{
    if (!m_received.stopLatched && !m_stopSince) {
        m_stopSince = m_clock.now();
    }
}

bool LastStatus::ages() const
{
    return m_clock.now() - m_taken >= kLateAfter || m_stopSince;
}

StationStatus LastStatus::now() const
{
    StationStatus status = m_received;
    const auto silent = std::chrono::duration_cast<std::chrono::milliseconds>(m_clock.now() - m_taken);
    for (AxisStatus* const axis : {&status.azimuth, &status.elevation}) {
        if (axis->age) {
            *axis->age += silent;
        }
    }
    if (status.drives) {
        for (DriveStatus* const drive : {&status.drives->azimuth, &status.drives->elevation}) {
            if (drive->readings.age) {
                *drive->readings.age += silent;
            }
        }
    }
    status.wind.age += silent;
    status.wind.isSilent = status.wind.isSilent || status.wind.age > status.profile->wind.silence;
    status.utc += silent;
    if (freshness(silent) != Freshness::Live) {
        refuseOldPlaces(status.permissions);
    }
    if (silent >= kNoDataAfter) {
        hideWork(status);
        complain(status, alarmEntry("window.station-silent"), {ageText(silent)});
    }
    if (m_stopSince && m_clock.now() - *m_stopSince >= kStopUnanswered) {
        complain(status, alarmEntry("window.stop-unconfirmed"));
    }
    return status;
}

}  // namespace boresight::ui
