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
// The clock of a client may be wrong by 3 s, and its position may be some seconds old.
constexpr Seconds kLag{5.0};
// The path ahead is searched in these steps, and no farther than this.
constexpr Angle kSampled = 0.5_deg;
constexpr Seconds kFarthestAhead{1800.0};
// A client that read the position within this time reads it.
constexpr std::chrono::seconds kReads{3};
// As long as a client may be silent before it loses control (ClientControl).
constexpr std::chrono::seconds kSilent{10};
constexpr std::chrono::seconds kNotice{60};
constexpr qsizetype kMostNames = 3;

UtcTime later(UtcTime utc, Seconds time)
{
    return utc + std::chrono::round<UtcTime::duration>(time);
}

// Why this profile permits no lock. Empty: it permits one.
QString lockObstacle(const profile::Profile& profile)
{
    if (!profile.site.known) {
        return Text::tr("the site of the mount is not set");
    }
    if (profile.clientLock == profile::ClientLock::Never) {
        return Text::tr("the setting clients.lock is \"never\"");
    }
    // A lock moves the mount along the edge of the permitted region, and the client is told nothing.
    return profile.rotctld.outsideLimits == profile::OutsideLimits::Refuse
               ? Text::tr("the setting rotctld.outside_limits is \"refuse\"")
               : QString();
}

// At most kMostNames of them.
QString namesText(QStringList names)
{
    names.sort();
    const QString first = names.mid(0, kMostNames).join(QStringLiteral(", "));
    return names.size() <= kMostNames ? first : Text::tr("%1 and %2 more").arg(first).arg(names.size() - kMostNames);
}

}  // namespace

bool OrbitLock::locks(const Source& client) const
{
    return m_locked && m_track.isTracking() && m_locked->client == client &&
           m_helm.current().continues(Activity::Streaming, client);
}

SkyPointing OrbitLock::directionOf(const Point& point) const
{
    const auto* const place = std::get_if<AxisPosition>(&point);
    return place ? m_helm.view().model.pointing().toSky(*place) : std::get<SkyPointing>(point);
}

void OrbitLock::sent(const Source& client, const Point& point)
{
    if (m_locked) {  // its motion ended since the last tick
        ended();
    }
    const std::uint64_t motionId = m_helm.current().motionId();
    if (!m_stream || m_stream->client != client || m_stream->motionId != motionId) {
        m_stream = Stream{.client = client, .motionId = motionId};
    }
    m_stream->recognition.add({.utc = m_helm.view().clock.utc(), .direction = directionOf(point)}, m_helm.now());
}

void OrbitLock::compare(const Point& point)
{
    m_helm.commanded(m_locked->client);
    m_locked->seen = m_helm.now();
    if (isNear(directionOf(point))) {
        m_locked->departing.reset();
    } else {
        const SteadyTime since = m_locked->departing ? m_locked->departing->since : m_helm.now();
        m_locked->departing = Departure{.last = point, .since = since};
    }
}

// Whether the point is near the path of the target, from shortly before the present place to the lead of the client.
bool OrbitLock::isNear(const SkyPointing& direction)
{
    const UtcTime now = std::max(m_helm.view().clock.utc(), m_track.rises());
    const auto here = m_track.targetAt(now);
    const auto soon = m_track.targetAt(later(now, Seconds(1.0)));
    if (!here || !soon) {
        return true;  // the tracking ends by itself
    }
    const Angle way = std::max(angleBetween(*here, *soon), 0.001_deg);  // in a second
    const Seconds step = std::max(Seconds(kSampled / way), Seconds(1.0));
    for (Seconds time = -kLag; time < kFarthestAhead; time += time < Seconds(0.0) ? Seconds(1.0) : step) {
        const auto there = m_track.targetAt(later(now, time));
        if (!there || (time > Seconds(0.0) && angleBetween(*here, *there) > m_locked->lead)) {
            return false;
        }
        if (angleBetween({there->azimuth, std::max(there->elevation, 0_deg)}, direction) <= kDeparts) {
            return true;
        }
    }
    return false;
}

void OrbitLock::positionRead(std::uint64_t clientId)
{
    if (m_locked && m_locked->client.clientId == clientId) {
        m_locked->seen = m_helm.now();
    }
    if (m_stream && m_stream->client.clientId == clientId) {
        m_stream->read = m_helm.now();
    }
}

// The points of the client still move the mount.
bool OrbitLock::goesOn() const
{
    return m_stream && m_helm.current().continues(Activity::Streaming, m_stream->client) &&
           m_helm.current().motionId() == m_stream->motionId;
}

bool OrbitLock::isReading(SteadyTime now) const
{
    return m_stream->read && now - *m_stream->read < kReads;
}

Result<> OrbitLock::answer(const request::TrackForClient& answer)
{
    if (!goesOn() || m_stream->client.clientId != answer.clientId || !m_stream->offered) {
        return failure(ErrorCode::NotAvailable, Text::tr("Boresight offers no target of this client any more."));
    }
    if (const QString& name = m_stream->offered->target.name; name != answer.target) {
        return failure(ErrorCode::Refused, Text::tr("The client tracks another target now: %1.").arg(name));
    }
    if (!answer.isWanted) {
        m_declined[answer.clientId].insert(answer.target);
        m_stream->offered.reset();
        return {};
    }
    return lock();
}

// Locks to the offered target.
Result<> OrbitLock::lock()
{
    const SteadyTime now = m_helm.now();
    if (!isReading(now)) {
        return failure(ErrorCode::Refused,
                       Text::tr("The client has not read the position in the last %1 s. Boresight tracks a target only "
                                "for a client that reads the position.")
                           .arg(kReads.count()));
    }
    const Source client = m_stream->client;
    const Offered offered = *m_stream->offered;
    return m_track.trackFor(client, offered.target).map([&] {
        m_stream.reset();
        m_locked = Locked{.client = client, .target = offered.target.name, .lead = offered.lead, .seen = now};
        m_helm.note(Severity::Advisory,
                    Text::tr("tracks %1. Boresight tracks it from its own orbit from now on").arg(m_locked->target));
        m_helm.clearAlarm(alarmEntry("client.lock-ended"));
        m_noticed.reset();
    });
}

void OrbitLock::step(SteadyTime now)
{
    if (m_noticed && now - *m_noticed >= kNotice) {
        m_helm.clearAlarm(alarmEntry("client.lock-ended"));
        m_noticed.reset();
    }
    if (m_locked) {
        watch(now);
    } else if (m_stream) {
        lookForTarget(now);
    }
}

void OrbitLock::watch(SteadyTime now)
{
    m_track.step(now);
    if (!m_track.isTracking()) {
        ended();
    } else if (m_locked->departing && now - m_locked->departing->since >= kDepartsFor) {
        departed();
    } else if (now - m_locked->seen >= kSilent) {
        endAndHold(Text::tr("the client was silent for %1 s").arg(kSilent.count()));
    }
}

OrbitLock::Ending OrbitLock::held(const QString& why)
{
    return {.why = why,
            .action = Text::tr("The mount holds"),
            .remedy = Text::tr("Nothing to do if the client has ended. Otherwise the next point of the client moves "
                               "the mount")};
}

// Only an act of a client gives a notice. For everything else the log has the reason.
std::optional<OrbitLock::Ending> OrbitLock::endOfMotion() const
{
    const CurrentMotion& current = m_helm.current();
    if (current.heldBy() == m_locked->client) {
        return held(Text::tr("the client stopped the mount"));
    }
    if (!current.moves() || current.commander().kind != SourceKind::Client) {
        return std::nullopt;
    }
    if (!current.isFor(m_locked->client)) {
        return Ending{.why = Text::tr("another client moves the mount"),
                      .action = Text::tr("The commands of the other client move the mount"),
                      .remedy = Text::tr("The page Clients shows which client has control")};
    }
    const QString remedy = Text::tr("Nothing to do if this is intended. Otherwise press Hold");
    if (current.is(Activity::Parking)) {
        return Ending{.why = Text::tr("the client parked the mount"),
                      .action = Text::tr("The mount moves to its park position"),
                      .remedy = remedy};
    }
    if (current.is(Activity::Streaming)) {
        return Ending{.why = Text::tr("the client stopped the mount"),
                      .action = Text::tr("The points of the client move the mount"),
                      .remedy = remedy};
    }
    return Ending{.why = Text::tr("the client sent a move command"),
                  .action = Text::tr("The move command of the client moves the mount"),
                  .remedy = remedy};
}

void OrbitLock::ended()
{
    if (const std::optional<Ending> ending = endOfMotion()) {
        over(*ending);
    } else {
        forgetLock();
    }
}

// The points of the client move the mount again, first the last one.
void OrbitLock::departed()
{
    const Source client = m_locked->client;
    const Point point = m_locked->departing->last;
    m_helm.note(Severity::Advisory,
                Text::tr("points more than %1° away from %2").arg(kDeparts.degrees()).arg(m_locked->target));
    Ending ending = held(Text::tr("the points of the client are more than %1° away from it").arg(kDeparts.degrees()));
    const Result<> moved = std::visit([&](const auto& there) { return m_helm.streamTo(there, client); }, point);
    if (moved) {
        ending.action = Text::tr("The points of the client move the mount");
        ending.remedy = Text::tr("Nothing to do if the client has another target");
    } else {
        m_helm.end(Severity::Warning, Text::tr("ends the motion: %1").arg(moved.error().text));
    }
    over(ending);
}

void OrbitLock::over(const Ending& ending)
{
    const QString name = m_locked->target;
    forgetLock();
    m_helm.raiseAlarm(alarmEntry("client.lock-ended"), {name, ending.why, ending.action, ending.remedy});
    m_noticed = m_helm.now();
}

void OrbitLock::endAndHold(const QString& why)
{
    m_helm.end(Severity::Advisory, Text::tr("ends the tracking: %1").arg(why));
    over(held(why));
}

void OrbitLock::forgetLock()
{
    m_track.forget();
    m_locked.reset();
}

void OrbitLock::lookForTarget(SteadyTime now)
{
    if (!goesOn()) {
        m_stream.reset();
        return;
    }
    const profile::Profile& profile = m_helm.view().profile;
    if (!lockObstacle(profile).isEmpty()) {
        m_stream->offered.reset();
        return;
    }
    if (isReading(now)) {
        m_stream->recognition.step(
            {.satellites = m_satellites, .site = profile.site.place(), .oldestDays = profile.orbit.oldestDays}, now);
    }
    if (m_stream->recognition.hasArrived()) {
        take(recognise::Recognition(m_stream->recognition.found()));  // a copy: the stream ends when a lock begins
    }
}

void OrbitLock::take(const recognise::Recognition& found)
{
    m_stream->offered.reset();
    if (found.fits.size() > 1) {
        QStringList names;
        for (const targets::Target& target : found.fits) {
            names.push_back(target.name);
        }
        tellOnce(QStringLiteral("several"),
                 Text::tr("The points fit several targets alike: %1. The points move the mount").arg(namesText(names)));
    } else if (found.fits.size() == 1 && !m_declined[m_stream->client.clientId].contains(found.fits.front().name)) {
        takeTarget(found);
    }
}

// A point at the horizon alone is too little for a lock without an answer: it may be a place on the Earth, and the
// mount would move at the rise.
void OrbitLock::takeTarget(const recognise::Recognition& found)
{
    const targets::Target& target = found.fits.front();
    m_stream->offered = Offered{.target = target, .lead = found.lead};
    if (!found.together.isEmpty()) {
        tellOnce(QStringLiteral("together ") + target.name,
                 Text::tr("%1 is at the same place as %2").arg(target.name, namesText(found.together)));
    }
    if (m_helm.view().profile.clientLock != profile::ClientLock::Always) {
        tellOnce(QStringLiteral("offer ") + target.name,
                 Text::tr("tracks %1. Boresight can track it from its own orbit: press Track it in the window, or set "
                          "clients.lock to \"always\"")
                     .arg(target.name));
    } else if (!found.isMoving) {
        tellOnce(QStringLiteral("offer ") + target.name,
                 Text::tr("waits for the rise of %1. Boresight tracks it from its own orbit when the points move along "
                          "it, or when you press Track it in the window")
                     .arg(target.name));
    } else if (const Result<> locked = lock(); !locked) {
        tellOnce(QStringLiteral("refusal ") + target.name,
                 Text::tr("tracks %1, but Boresight cannot track it from its own orbit: %2")
                     .arg(target.name, locked.error().text));
    }
}

// Once in a stream.
void OrbitLock::tellOnce(const QString& about, const QString& text)
{
    if (m_stream->told.insert(about).second) {
        m_helm.note(Severity::Advisory, text);
    }
}

void OrbitLock::gone(const Source& client)
{
    if (locks(client)) {
        endAndHold(Text::tr("the client has disconnected"));
    } else if (m_locked && m_locked->client == client) {
        ended();
    } else if (m_stream && m_stream->client == client) {
        m_stream.reset();
    }
    m_declined.erase(client.clientId);
}

void OrbitLock::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    m_track.profileChanged(before, after);
    const bool isElsewhere = before.site.known != after.site.known || before.site.place() != after.site.place();
    const QString why = isElsewhere ? Text::tr("the site of the mount was changed") : lockObstacle(after);
    if (why.isEmpty()) {
        return;
    }
    m_stream.reset();
    if (m_locked && locks(m_locked->client)) {
        endAndHold(why);
    }
}

void OrbitLock::describe(StationStatus& status) const
{
    if (m_locked) {
        status.clientTarget =
            RecognisedTarget{.clientId = m_locked->client.clientId, .name = m_locked->target, .isLocked = true};
    } else if (m_stream && m_stream->offered) {
        status.clientTarget =
            RecognisedTarget{.clientId = m_stream->client.clientId, .name = m_stream->offered->target.name};
    }
    m_track.describe(status);
}

}  // namespace boresight::sources
