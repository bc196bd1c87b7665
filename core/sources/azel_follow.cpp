// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/azel_follow.h"

#include "core/base/text.h"
#include "core/control/beam_report.h"
#include "core/sources/roomy_start.h"
#include "core/units/angle_between.h"
#include "core/units/degrees_text.h"

namespace boresight::sources {
namespace {

// The rate of a set-point is computed from the directions of the Moon now and this much later.
constexpr std::chrono::milliseconds kMoonApart{20};
// Time between two points of the way by which the wrap is chosen.
constexpr std::chrono::minutes kWayStep{5};
// With an interval of at most this long the mount gets a new target in each tick.
constexpr Seconds kAllTheTime{1.0};
// The Moon counts as set at this elevation and as risen at 0°. So the steps of the file do not park the mount twice.
constexpr Angle kMoonSets = Angle::fromDegrees(-0.3);

const Source& azelSource()
{
    static const Source source{.kind = SourceKind::Operator, .name = QStringLiteral("azel.dat")};
    return source;
}

}  // namespace

Result<> AzelFollow::receive(const SourceReport& report)
{
    if (const auto* const reading = std::get_if<azel::AzelReading>(&report)) {
        const Clock& clock = helm().view().clock;
        m_feed.take(*reading, clock.now(), clock.computerUtc());
    }
    return {};
}

Result<> AzelFollow::isUsable() const
{
    const ControlParts view = helm().view();
    return m_feed.isFresh(view.now).and_then([&]() -> Result<> {
        if (m_moon.isElsewhere()) {
            return failure(
                ErrorCode::Refused,
                Text::tr("its Moon is %1 away from the computed Moon. The locator in WSJT-X or the site is wrong")
                    .arg(degreesText(*m_moon.apart())));
        }
        if (view.profile.azel.onlyWhileReceiving == profile::OnlyWhileReceiving::On && !m_feed.text()->radio) {
            return failure(ErrorCode::Refused, Text::tr("it does not show whether the radio transmits, and the setting "
                                                        "only_while_receiving is on"));
        }
        return {};
    });
}

Result<> AzelFollow::ask(const request::FollowAzel&, const Source& by)
{
    const ControlParts view = helm().view();
    m_moon.look(view, m_feed);
    return operatorOnly(by).and_then([&] { return helm().mayPoint(by); }).and_then([&]() -> Result<> {
        if (const Result<> usable = isUsable(); !usable) {
            return failure(usable.error().code, Text::tr("azel.dat cannot be used: %1").arg(usable.error().text));
        }
        forget();
        m_utc = {};
        const UtcTime utc = m_utc.now(view.clock);
        m_followed = Followed{};
        setUp(m_moon.at(utc).elevation >= Angle{}, utc);
        Result<> driven = drive(view.now, utc);
        if (driven) {
            helm().clearAlarm(alarmEntry("azel.ended"));
        } else {
            m_followed.reset();
        }
        return driven;
    });
}

void AzelFollow::step(SteadyTime now)
{
    m_moon.look(helm().view(), m_feed);
    if (!m_followed) {
        return;
    }
    const CurrentMotion& current = helm().current();
    if (!current.isFor(azelSource()) || !(current.is(Activity::Streaming) || current.is(Activity::Parking))) {
        forget();  // the tracking was ended, or another source moves the mount
        return;
    }
    if (current.motionId() != m_followed->motionId) {
        end(Severity::Advisory, Text::tr("ends the tracking, because control was given away"));
        return;
    }
    if (const QString why = whyToEnd(now); !why.isEmpty()) {
        end(Severity::Warning, Text::tr("ends the tracking: %1").arg(why));
        helm().raiseAlarm(alarmEntry("azel.ended"), {why});
        return;
    }
    tellDifference();
    if (const Result<> driven = drive(now, m_utc.now(helm().view().clock)); !driven) {
        end(Severity::Warning, Text::tr("ends the tracking: %1").arg(driven.error().text));
    }
}

// Empty: the tracking continues. A stale file ends the tracking only after StaleWait::kLongest.
QString AzelFollow::whyToEnd(SteadyTime now)
{
    const Result<> usable = isUsable();
    if (usable) {
        m_stale.end();
        return {};
    }
    if (usable.error().code == ErrorCode::Refused) {
        return usable.error().text;
    }
    return m_stale.isTooLong(usable.error().text, now) ? usable.error().text : QString();
}

void AzelFollow::tellDifference()
{
    if (m_moon.differs()) {
        helm().raiseAlarm(alarmEntry("azel.differs"), {degreesText(*m_moon.apart())});
    } else {
        helm().clearAlarm(alarmEntry("azel.differs"));
    }
}

AzelPhase AzelFollow::wantedPhase() const
{
    if (m_stale.isWaiting()) {
        return AzelPhase::Stale;
    }
    const ControlParts view = helm().view();
    const bool transmits = m_feed.text()->radio == azel::Radio::Transmits;
    return transmits && view.profile.azel.onlyWhileReceiving == profile::OnlyWhileReceiving::On
               ? AzelPhase::Transmitting
           : m_followed->isUp ? AzelPhase::Following
                              : AzelPhase::BelowHorizon;
}

bool AzelFollow::isParking() const
{
    return helm().current().is(Activity::Parking) && helm().current().isFor(azelSource());
}

void AzelFollow::setUp(bool isUp, UtcTime utc)
{
    m_followed->isUp = isUp;
    m_followed->next = isUp ? m_moon.nextSet(utc) : m_moon.nextRise(utc);
}

void AzelFollow::watchHorizon(UtcTime utc)
{
    const Angle elevation = m_moon.at(utc).elevation;
    const bool isUp = elevation > (m_followed->isUp ? kMoonSets : Angle{});
    if (isUp != m_followed->isUp) {
        setUp(isUp, utc);
    }
}

Result<> AzelFollow::drive(SteadyTime now, UtcTime utc)
{
    watchHorizon(utc);
    m_followed->skyRate = m_moon.skyRate(utc);
    const AzelPhase phase = wantedPhase();
    const Result<> driven = phase == AzelPhase::Following      ? follow(now, utc)
                            : phase == AzelPhase::BelowHorizon ? park()
                                                               : stand();
    return driven.map([&] {
        m_followed->phase = phase;
        m_followed->motionId = helm().current().motionId();
    });
}

bool AzelFollow::isDue(const SkyPointing& moon, SteadyTime now) const
{
    const profile::Profile& profile = helm().view().profile;
    const std::optional<Target>& target = m_followed->target;
    if (!target) {
        return true;
    }
    const bool isOver = profile.azel.interval <= kAllTheTime || now - target->since >= profile.azel.interval;
    return isOver &&
           angleBetween(target->now, moon) >= helm().view().antenna.inUse().beamWidth * profile.azel.beamFraction;
}

// On a wrap that has room until the Moon sets. Only the computed Moon is known ahead, so else the result is empty.
std::optional<AxisPosition> AzelFollow::roomyPlace(UtcTime utc)
{
    std::vector<targets::SkyMoment> way;
    if (m_moon.interpolates() && m_followed->next) {
        for (UtcTime then = utc; then < *m_followed->next; then += kWayStep) {
            way.push_back({.utc = then, .direction = m_moon.at(then)});
        }
        way.push_back({.utc = *m_followed->next, .direction = m_moon.at(*m_followed->next)});
    }
    return roomyStart(helm().view(), way);
}

Result<> AzelFollow::follow(SteadyTime now, UtcTime utc)
{
    const auto at = [&](UtcTime when) {
        SkyPointing moon = m_moon.at(when);
        moon.elevation = std::max(moon.elevation, Angle{});  // at rise and set it may be slightly negative
        return moon;
    };
    const profile::AzelSettings& settings = helm().view().profile.azel;
    if (const SkyPointing moon = at(utc); isDue(moon, now)) {
        const bool isSteady = settings.interval <= kAllTheTime && settings.beamFraction <= 0.0;
        m_followed->target = Target{.now = moon, .soon = isSteady ? at(utc + kMoonApart) : moon, .since = now};
    }
    m_followed->standing.reset();
    if (!m_followed->place) {
        m_followed->place = roomyPlace(utc);
    }
    return helm()
        .lead({.now = m_followed->target->now,
               .soon = m_followed->target->soon,
               .apart = kMoonApart,
               .near = m_followed->place},
              azelSource(), Text::tr("track the Moon by WSJT-X"))
        .map([&](const AxisPosition& place) { m_followed->place = place; });
}

// Starts the motion to the park position. Does nothing while the mount is on its way there or parked.
Result<> AzelFollow::park()
{
    m_followed->standing.reset();
    m_followed->target.reset();
    m_followed->place.reset();
    if (isParking()) {
        return {};
    }
    const AxisPosition place = Gates(helm().view()).park();
    return helm().goTo(place, Activity::Parking, azelSource(),
                       Text::tr("park at %1, because the Moon is below the horizon").arg(helm().directionText(place)));
}

// Brakes and holds the place where the axes stop.
Result<> AzelFollow::stand()
{
    const ControlParts view = helm().view();
    if (isParking() && view.motion.atRest()) {
        return {};
    }
    if (!m_followed->standing) {
        const AxisPosition place = view.stoppingPlace();
        const AxisPosition& trim =
            view.motion.trim();  // the helm adds the trim to the target, so it is subtracted here
        m_followed->standing =
            AxisPosition{.azimuth = place.azimuth - trim.azimuth, .elevation = place.elevation - trim.elevation};
    }
    const SkyPointing direction = view.model.pointing().toSky(*m_followed->standing);
    return helm()
        .lead({.now = direction, .soon = direction, .apart = kMoonApart, .near = m_followed->standing}, azelSource(),
              Text::tr("track the Moon by WSJT-X"))
        .map([](const AxisPosition&) {});
}

void AzelFollow::forget()
{
    m_followed.reset();
    m_stale.end();
    helm().clearAlarm(alarmEntry("azel.differs"));
}

void AzelFollow::end(Severity severity, const QString& why)
{
    forget();
    helm().end(severity, why);
}

std::optional<SkyPointing> AzelFollow::targetAt(UtcTime utc)
{
    return m_followed && m_moon.interpolates() ? std::optional(m_moon.at(utc)) : std::nullopt;
}

// While the mount stands still for the transmitter, the status still shows the moving Moon as its target.
void AzelFollow::aimAtTheMoon(StationStatus& status) const
{
    const ControlParts view = helm().view();
    const SkyPointing moon = m_feed.text()->moon;
    const AxisPosition place = view.model.resolve(moon, m_followed->place.value_or(view.motion.place())).position;
    status.target = moon;
    status.azimuth.target = place.azimuth;
    status.elevation.target = place.elevation;
    addBeam(status, view.model.pointing());
    status.stateReason = Text::tr("stands still while WSJT-X transmits");
}

void AzelFollow::describe(StationStatus& status) const
{
    const ControlParts view = helm().view();
    const Result<> usable = isUsable();
    status.azel = {.path = m_feed.path(),
                   .problem = usable ? m_feed.problem(view.now) : usable.error().text,
                   .age = m_feed.age(view.now, view.clock.computerUtc()),
                   .apart = m_moon.apart(),
                   .interpolates = m_moon.interpolates()};
    if (m_feed.text()) {
        status.azel.moon = m_feed.text()->moon;
        status.azel.transmits = m_feed.text()->radio ? std::optional(*m_feed.text()->radio == azel::Radio::Transmits)
                                                     : std::optional<bool>();
    }
    if (!usable && status.permissions.allows(Action::FollowAzel)) {
        status.permissions.refuse(Action::FollowAzel, Text::tr("azel.dat cannot be used: %1").arg(usable.error().text));
    }
    if (m_followed) {
        status.azel.phase = m_followed->phase;
        status.azel.next = m_followed->next;
        if (m_followed->phase == AzelPhase::Transmitting && m_followed->isUp) {
            aimAtTheMoon(status);
        }
        status.tracked =
            TrackedTarget{.name = Text::tr("Moon (WSJT-X)"), .isUp = m_followed->isUp, .next = m_followed->next};
        status.tracked->skyRate = m_followed->skyRate;
    }
}

}  // namespace boresight::sources
