// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/orbit_lock.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/units/angle_between.h"

#include <algorithm>
#include <utility>

namespace boresight::sources {
namespace {

constexpr Angle kDeparts = 3_deg;
constexpr std::chrono::seconds kDepartsFor{5};
// A client with a threshold of 5° aims ahead by it. Its position may be some seconds old.
constexpr Angle kLead = 6.5_deg;
constexpr Seconds kLag{5.0};
constexpr Angle kSampled = 0.5_deg;
// As long as a client may be silent before it loses control (ClientControl).
constexpr std::chrono::seconds kSilent{10};
constexpr std::chrono::seconds kNotice{60};

UtcTime later(UtcTime utc, Seconds time)
{
    return utc + std::chrono::round<UtcTime::duration>(time);
}

const orbit::ElementSet* satelliteOf(const targets::Target& target)
{
    return std::get_if<orbit::ElementSet>(&target.kind);
}

}  // namespace

bool OrbitLock::locks(const Source& client) const
{
    const CurrentMotion& current = m_helm.current();
    return isLocked() && m_track.isTracking() && *m_client == client && current.continues(Activity::Streaming, client);
}

SkyPointing OrbitLock::directionOf(const Point& point) const
{
    const auto* const place = std::get_if<AxisPosition>(&point);
    return place ? m_helm.view().model.pointing().toSky(*place) : std::get<SkyPointing>(point);
}

void OrbitLock::sent(const Source& client, const Point& point)
{
    const CurrentMotion& current = m_helm.current();
    if (isLocked()) {  // it stopped since the last tick, and goes on
        over(Text::tr("the client stopped the mount"));
    }
    if (!m_client || *m_client != client || m_motionId != current.motionId()) {
        forget();
        m_client = client;
        m_motionId = current.motionId();
    }
    m_recognition.add({.utc = m_helm.view().clock.utc(), .direction = directionOf(point)}, m_helm.now());
}

void OrbitLock::compare(const Point& point)
{
    m_seen = m_helm.now();
    if (isNear(directionOf(point))) {
        m_departing.reset();
        return;
    }
    m_departsSince = m_departing ? m_departsSince : m_seen;
    m_departing = point;
}

// Whether the point is near the path of the target, from shortly before the present place to the farthest lead of a
// client.
bool OrbitLock::isNear(const SkyPointing& direction)
{
    const UtcTime now = std::max(m_helm.view().clock.utc(), m_track.rises());
    const auto here = m_track.targetAt(now);
    const auto soon = m_track.targetAt(later(now, Seconds(1.0)));
    if (!here || !soon) {
        return true;  // the tracking ends by itself
    }
    // The time that the target needs for kSampled, at least 1 s.
    const Angle way = std::max(angleBetween(*here, *soon), 0.001_deg);
    const Seconds step = std::max(Seconds(kSampled / way), Seconds(1.0));
    const auto isAt = [&](Seconds time) {
        const auto there = m_track.targetAt(later(now, time));
        return there && angleBetween({there->azimuth, std::max(there->elevation, 0_deg)}, direction) <= kDeparts;
    };
    const int ahead = static_cast<int>(kLead / kSampled);
    for (int i = 0; i <= ahead; ++i) {
        if (isAt(i * step)) {
            return true;
        }
    }
    return isAt(-kLag);
}

void OrbitLock::positionRead(std::uint64_t clientId)
{
    if (m_client && m_client->clientId == clientId) {
        m_seen = m_helm.now();
        m_recognition.setSeen(m_helm.now());
    }
}

Result<> OrbitLock::answer(const request::TrackForClient& answer)
{
    if (!m_client || m_client->clientId != answer.clientId || !m_target || m_isLocked) {
        return failure(ErrorCode::NotAvailable, Text::tr("Boresight offers no target of this client any more."));
    }
    if (!answer.isWanted) {
        m_answered[m_client->clientId].insert(m_target->name);
        m_target.reset();
        return {};
    }
    return lock();
}

Result<> OrbitLock::lock()
{
    m_answered[m_client->clientId].insert(m_target->name);
    const Result<> locked = m_track.trackFor(*m_client, *m_target);
    if (!locked) {
        m_target.reset();
        return locked;
    }
    m_isLocked = true;
    m_departing.reset();
    m_seen = m_helm.now();
    m_helm.note(Severity::Advisory,
                Text::tr("tracks %1. Boresight tracks it from its own orbit from now on").arg(m_target->name));
    m_helm.clearAlarm(alarmEntry("client.lock-ended"));
    m_noticed.reset();
    return {};
}

void OrbitLock::step(SteadyTime now)
{
    if (m_noticed && now - *m_noticed >= kNotice) {
        m_helm.clearAlarm(alarmEntry("client.lock-ended"));
        m_noticed.reset();
    }
    if (isLocked()) {
        watch(now);
    } else if (m_client) {
        lookForTarget(now);
    }
}

void OrbitLock::watch(SteadyTime now)
{
    m_track.step(now);
    if (!m_track.isTracking()) {
        ended();
    } else if (m_departing && now - m_departsSince >= kDepartsFor) {
        departed();
    } else if (now - m_seen >= kSilent) {
        endAndHold(Text::tr("the client was silent for %1 s").arg(kSilent.count()));
    }
}

// Only an act of the client gives a notice. For everything else the log has the reason.
void OrbitLock::ended()
{
    const CurrentMotion& current = m_helm.current();
    if (current.heldBy() == m_client) {
        over(Text::tr("the client stopped the mount"));
    } else if (current.is(Activity::Parking) && current.isFor(*m_client)) {
        over(Text::tr("the client parked the mount"));
    } else {
        forget();
    }
}

// The points of the client move the mount again, first the last one.
void OrbitLock::departed()
{
    const Source client = *m_client;
    const Point point = *m_departing;
    m_helm.note(Severity::Advisory,
                Text::tr("points more than %1° away from %2").arg(kDeparts.degrees()).arg(m_target->name));
    over(Text::tr("the points of the client are more than %1° away from it").arg(kDeparts.degrees()));
    const Result<> moved = std::visit([&](const auto& there) { return m_helm.streamTo(there, client); }, point);
    if (!moved) {
        m_helm.end(Severity::Warning, Text::tr("ends the motion: %1").arg(moved.error().text));
    }
}

void OrbitLock::over(const QString& why)
{
    const QString name = m_target->name;
    forget();
    m_helm.raiseAlarm(alarmEntry("client.lock-ended"), {name, why});
    m_noticed = m_helm.now();
}

void OrbitLock::endAndHold(const QString& why)
{
    m_helm.end(Severity::Advisory, Text::tr("ends the tracking: %1").arg(why));
    over(why);
}

void OrbitLock::forget()
{
    m_track.forget();
    m_recognition.clear();
    m_client.reset();
    m_target.reset();
    m_isLocked = false;
    m_departing.reset();
}

void OrbitLock::lookForTarget(SteadyTime now)
{
    const CurrentMotion& current = m_helm.current();
    if (!current.is(Activity::Streaming) || !current.isFor(*m_client) || current.motionId() != m_motionId) {
        forget();
        return;
    }
    const profile::Profile& profile = m_helm.view().profile;
    if (rule() == profile::ClientLock::Never || !profile.site.known) {
        m_target.reset();
        return;
    }
    m_recognition.step(
        {.satellites = m_satellites, .site = profile.site.place(), .oldestDays = profile.orbit.oldestDays}, now);
    if (m_recognition.hasArrived()) {
        take(m_recognition.found());
    }
}

void OrbitLock::take(const recognise::Recognition& found)
{
    m_target.reset();
    if (found.fits.size() > 1) {
        QStringList names;
        for (const targets::Target& target : found.fits) {
            names.push_back(target.name);
        }
        tellOnce(Text::tr("The points fit several targets alike: %1. The points move the mount")
                     .arg(names.join(QStringLiteral(", "))));
    } else if (found.fits.size() == 1 && (rule() == profile::ClientLock::Always ||
                                          !m_answered[m_client->clientId].contains(found.fits.front().name))) {
        offer(found.fits.front(), found.together);
    }
}

// A target that the profile locks to needs no answer.
void OrbitLock::offer(const targets::Target& target, const QStringList& together)
{
    m_target = target;
    if (!together.isEmpty()) {
        tellOnce(Text::tr("%1 is at the same place as %2").arg(target.name, together.join(QStringLiteral(", "))));
    }
    if (rule() != profile::ClientLock::Always) {
        tellOnce(Text::tr("tracks %1. Boresight can track it from its own orbit: press Track it in the window, or set "
                          "clients.lock to \"always\"")
                     .arg(target.name));
        return;
    }
    if (const Result<> locked = lock(); !locked) {
        tellOnce(Text::tr("tracks %1, but Boresight cannot track it from its own orbit: %2")
                     .arg(target.name, locked.error().text));
    }
}

void OrbitLock::tellOnce(const QString& text)
{
    if (m_told[m_client->clientId].insert(text).second) {
        m_helm.note(Severity::Advisory, text);
    }
}

void OrbitLock::gone(const Source& client)
{
    if (locks(client)) {
        endAndHold(Text::tr("the client has disconnected"));
    } else if (m_client == client) {
        isLocked() ? ended() : forget();
    }
    m_answered.erase(client.clientId);
    m_told.erase(client.clientId);
}

void OrbitLock::setSatellites(const recognise::SharedSatellites& satellites)
{
    m_satellites = satellites;
    const orbit::ElementSet* const locked = m_client && locks(*m_client) ? satelliteOf(*m_target) : nullptr;
    if (locked != nullptr && std::ranges::find(*satellites, *locked) == satellites->end()) {
        endAndHold(Text::tr("its elements have changed"));
    }
}

void OrbitLock::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    const bool isElsewhere = before.site.known != after.site.known || before.site.place() != after.site.place();
    m_track.profileChanged(before, after);
    if (!m_client || !locks(*m_client)) {
        return;
    }
    if (isElsewhere) {
        endAndHold(Text::tr("the site of the mount was changed"));
    } else if (after.clientLock == profile::ClientLock::Never) {
        endAndHold(Text::tr("the setting clients.lock was changed"));
    }
}

void OrbitLock::describe(StationStatus& status) const
{
    if (m_client && m_target) {
        status.clientTarget =
            RecognisedTarget{.clientId = m_client->clientId, .name = m_target->name, .isLocked = m_isLocked};
    }
    m_track.describe(status);
}

}  // namespace boresight::sources
