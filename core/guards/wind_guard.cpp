// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/guards/wind_guard.h"

#include "core/alarms/catalogue.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/base/time_of_day.h"

namespace boresight {
namespace {

using Minutes = std::chrono::duration<double, std::ratio<60>>;

wind::Limits limitsOf(const profile::WindSettings& settings)
{
    return {.stowAbove = settings.stowAbove,
            .releaseBelow = settings.releaseBelow,
            .gust = settings.gust,
            .calm = Minutes(settings.calm),
            .silence = settings.silence,
            .silenceCounts = settings.whenSilent == profile::WhenSilent::Stow};
}

QString speedText(double speed)
{
    return toQString(formatFixed(speed, 1));
}

QString minutesText(double minutes)
{
    return QString::number(minutes, 'g', 4);
}

}  // namespace

WindGuard::WindGuard(const profile::InForce& profile, const Clock& clock, AlarmBoard& alarms)
    : m_profile(profile), m_clock(clock), m_alarms(alarms), m_watch(m_clock.now())
{}

void WindGuard::take(double speed)
{
    ++m_accepted;
    m_watch.take(speed, m_clock.now());
}

void WindGuard::step()
{
    if (!m_profile->wind.isRead()) {
        return;
    }
    m_watch.step(limitsOf(m_profile->wind), m_clock.now());
    if (m_watch.isSilent() && !m_isSilent) {
        const auto age = std::chrono::duration_cast<UtcTime::duration>(m_watch.age(m_clock.now()));
        m_lastHeard = sinceText(timeOfDayText(m_clock.utc() - age));
    }
    m_isSilent = m_watch.isSilent();
    if (m_override && m_clock.now() >= m_override->until) {
        m_override.reset();
    }
    const bool forbids = isStrong() && !m_override;
    if (forbids && !m_forbids) {
        ++m_onsets;
    }
    m_forbids = forbids;
}

void WindGuard::tell(bool parks)
{
    if (m_profile->wind.isRead()) {
        tellStow(parks);
        tellSilence();
    }
}

void WindGuard::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (before.wind == after.wind) {
        return;
    }
    m_watch = wind::WindWatch(m_clock.now());
    m_override.reset();
    m_forbids = false;
    m_isSilent = false;
    m_accepted = 0;
    m_isFirst = false;
    m_alarms.clear(alarmEntry("wind.parks"));
    m_alarms.clear(alarmEntry("wind.silent"));
}

QString WindGuard::sinceText(const QString& time) const
{
    if (m_watch.last()) {
        return time;
    }
    return (m_isFirst ? Text::tr("the start at %1") : Text::tr("the change of the profile at %1")).arg(time);
}

QString WindGuard::silentSince() const
{
    const QString trouble = m_trouble.endsWith(QLatin1Char('.')) ? m_trouble.chopped(1) : m_trouble;
    return trouble.isEmpty() ? m_lastHeard : QStringLiteral("%1 (%2)").arg(m_lastHeard, trouble);
}

QString WindGuard::causeText() const
{
    if (m_watch.cause() == wind::WindWatch::Cause::Silence) {
        return m_isSilent ? Text::tr("The wind is unknown. No reading has come since %1").arg(silentSince())
                          : Text::tr("The wind was unknown. No reading came after %1").arg(m_lastHeard);
    }
    return Text::tr("The wind reached %1 m/s. The limit is %2 m/s")
        .arg(speedText(m_watch.peak()), speedText(m_profile->wind.stowAbove));
}

void WindGuard::tellStow(bool parks)
{
    const profile::WindSettings& settings = m_profile->wind;
    if (!isStrong()) {
        m_alarms.clear(alarmEntry("wind.parks"));
    } else if (m_override) {
        m_alarms.raise(alarmEntry("wind.overridden"), {causeText(), timeOfDayText(m_override->utc)});
    } else if (parks) {
        m_alarms.raise(alarmEntry("wind.parks"),
                       {causeText(), speedText(settings.releaseBelow), minutesText(settings.calm)});
    } else {
        m_alarms.raise(alarmEntry("wind.not-parked"), {causeText()});
    }
}

// While silence itself parks the mount, wind.parks is the only alarm.
void WindGuard::tellSilence()
{
    const wind::WindWatch::Cause cause = m_watch.cause();
    if (!m_watch.isSilent() || cause == wind::WindWatch::Cause::Silence) {
        m_alarms.clear(alarmEntry("wind.silent"));
    } else if (cause == wind::WindWatch::Cause::Wind) {
        m_alarms.raise(alarmEntry("wind.silent-while-strong"), {silentSince()});
    } else {
        m_alarms.raise(alarmEntry("wind.silent"), {silentSince()});
    }
}

Result<> WindGuard::unlessForbidden(const QString& text) const
{
    if (!m_forbids) {
        return {};
    }
    const profile::WindSettings& settings = m_profile->wind;
    return failure(ErrorCode::Refused,
                   text.arg(obstacle(), speedText(settings.releaseBelow), minutesText(settings.calm)));
}

Result<> WindGuard::admits() const
{
    return unlessForbidden(Text::tr("%1 Only Park moves the mount until the wind stays below %2 m/s for %3 min."));
}

Result<> WindGuard::admitsClients() const
{
    return unlessForbidden(Text::tr("%1 Hand over when the wind has stayed below %2 m/s for %3 min."));
}

Result<> WindGuard::admitsUnpark() const
{
    return unlessForbidden(Text::tr("%1 The mount stays parked until the wind stays below %2 m/s for %3 min."));
}

Result<> WindGuard::mayOverride() const
{
    return m_forbids ? Result<>{} : failure(ErrorCode::Refused, Text::tr("The wind does not forbid any motion."));
}

void WindGuard::override()
{
    const Minutes time(m_profile->wind.overrideFor);
    m_override = {.until = m_clock.now() + std::chrono::duration_cast<SteadyTime::duration>(time),
                  .utc = m_clock.utc() + std::chrono::duration_cast<UtcTime::duration>(time)};
    m_forbids = false;
}

WindStatus WindGuard::status() const
{
    if (!m_profile->wind.isRead()) {
        return {};
    }
    return {.source = toQString(m_profile->wind.source),
            .speed = m_watch.last(),
            .age = m_watch.age(m_clock.now()),
            .isSilent = m_watch.isSilent(),
            .obstacle = obstacle(),
            .overriddenUntil = m_override && isStrong() ? std::optional(m_override->utc) : std::nullopt,
            .accepted = m_accepted};
}

}  // namespace boresight
