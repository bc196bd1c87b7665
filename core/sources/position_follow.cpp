// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/position_follow.h"

#include "core/base/text.h"
#include "core/orbit/topocentric.h"
#include "core/units/angle_between.h"
#include "core/units/degrees_text.h"

#include <algorithm>

namespace boresight::sources {
namespace {

// The rate of a set-point is computed from the directions now and this much later.
constexpr std::chrono::milliseconds kFlightApart{20};
// Below this distance from the antenna a position gives no useful direction.
constexpr double kNearestFlight = 0.02;  // km
constexpr Angle kFarthestReturn = Angle::fromDegrees(10.0);

const Source& positionSource()
{
    static const Source source{.kind = SourceKind::Operator, .name = QStringLiteral("position")};
    return source;
}

position::FeedLimits limitsOf(const profile::PositionSettings& settings)
{
    return {.name = toQString(settings.name), .stale = settings.stale, .fastest = settings.fastest};
}

}  // namespace

Result<> PositionFollow::receive(const SourceReport& report)
{
    const auto* const read = std::get_if<Result<position::PositionText>>(&report);
    if (!read) {
        return {};
    }
    const Clock& clock = helm().view().clock;
    m_feed.setLimits(limitsOf(helm().view().profile.position));
    return m_feed.take(*read, clock.now(), clock.computerUtc());
}

void PositionFollow::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (!after.position.comesFromWhere(before.position)) {
        m_feed = {};
    }
    m_feed.setLimits(limitsOf(after.position));
}

Result<> PositionFollow::isUsable() const
{
    const ControlParts view = helm().view();
    if (!view.profile.site.known) {
        return failure(ErrorCode::Refused, Text::tr("the site of the mount is not set"));
    }
    return m_feed.isFresh(view.now).and_then([&] { return directionAt(view.now); }).map([](const auto&) {});
}

// A position below the horizon gets elevation 0°, because radio waves follow the horizon.
Result<SkyPointing> PositionFollow::directionAt(SteadyTime now) const
{
    const ControlParts view = helm().view();
    const orbit::LookAngles seen = orbit::Observer(view.profile.site.place()).look(m_feed.at(now));
    if (seen.kilometres < kNearestFlight) {
        return failure(ErrorCode::NoAnswer, Text::tr("the position is the site of the mount"));
    }
    return SkyPointing{.azimuth = seen.direction.azimuth, .elevation = std::max(seen.direction.elevation, Angle{})};
}

Result<> PositionFollow::ask(const request::FollowPosition&, const Source& by)
{
    const ControlParts view = helm().view();
    return operatorOnly(by).and_then([&] { return helm().mayPoint(by); }).and_then([&]() -> Result<> {
        if (const Result<> usable = isUsable(); !usable) {
            return failure(ErrorCode::Refused, Text::tr("No position to track: %1").arg(usable.error().text));
        }
        forget();
        m_followed = Followed{.site = view.profile.site.place()};
        Result<> driven = follow(view.now);
        if (driven) {
            m_followed->motionId = helm().current().motionId();
            helm().clearAlarm(alarmEntry("position.ended"));
        } else {
            m_followed.reset();
        }
        return driven;
    });
}

void PositionFollow::step(SteadyTime now)
{
    if (!m_followed) {
        return;
    }
    const CurrentMotion& current = helm().current();
    if (!current.isFor(positionSource()) || !current.is(Activity::Streaming)) {
        forget();  // the tracking was ended, or another source moves the mount
        return;
    }
    if (current.motionId() != m_followed->motionId) {
        end(Severity::Advisory, Text::tr("ends the tracking, because control was given away"));
        return;
    }
    if (const QString why = whyToEnd(now); !why.isEmpty()) {
        end(Severity::Warning, Text::tr("ends the tracking: %1").arg(why));
        helm().raiseAlarm(alarmEntry("position.ended"), {why});
        return;
    }
    if (const Result<> driven = follow(now); !driven) {
        end(Severity::Warning, Text::tr("ends the tracking: %1").arg(driven.error().text));
    }
}

// After a short silence the tracking continues if the new direction is near the last one. A far direction may belong to
// another object, so it ends the tracking.
QString PositionFollow::whyToEnd(SteadyTime now)
{
    if (helm().view().profile.site.place() != m_followed->site) {
        return Text::tr("the site of the mount was changed");
    }
    const Result<> usable = isUsable();
    if (usable) {
        if (const Angle away = returnedBy(now); away > kFarthestReturn) {
            return Text::tr("the new position is %1 from the last position").arg(degreesText(away, 1));
        }
        m_stale.end();
        return {};
    }
    return m_stale.isTooLong(usable.error().text, now) ? usable.error().text : QString();
}

// After a silence: the angle between the last direction and the new one. Else 0°.
Angle PositionFollow::returnedBy(SteadyTime now) const
{
    const Result<SkyPointing> here = directionAt(now);
    const bool wasLost = m_stale.isWaiting() && m_followed->direction;
    return here && wasLost ? angleBetween(*m_followed->direction, *here) : Angle{};
}

Result<PositionFollow::Leg> PositionFollow::legAt(SteadyTime now) const
{
    if (m_stale.isWaiting() && m_followed->direction) {
        return Leg{.here = *m_followed->direction, .soon = *m_followed->direction};
    }
    return directionAt(now).and_then([&](const SkyPointing& here) {
        return directionAt(now + kFlightApart).map([&](const SkyPointing& soon) {
            return Leg{.here = here, .soon = soon};
        });
    });
}

Result<> PositionFollow::follow(SteadyTime now)
{
    return legAt(now).and_then([&](const Leg& leg) {
        const auto& last = m_feed.last();
        const QString name = last && !last->name.isEmpty() ? last->name : Text::tr("the position");
        return helm()
            .lead({.now = leg.here, .soon = leg.soon, .apart = kFlightApart, .near = m_followed->place},
                  positionSource(), Text::tr("track %1").arg(name))
            .map([&](const AxisPosition& place) {
                m_followed->place = place;
                m_followed->direction = leg.here;
            });
    });
}

void PositionFollow::forget()
{
    m_followed.reset();
    m_stale.end();
}

void PositionFollow::end(Severity severity, const QString& why)
{
    forget();
    helm().end(severity, why);
}

void PositionFollow::describe(StationStatus& status) const
{
    const ControlParts view = helm().view();
    const Result<> usable = isUsable();
    status.position = {.problem = usable ? QString() : usable.error().text,
                       .age = m_feed.age(view.now),
                       .accepted = m_feed.accepted(),
                       .refused = m_feed.refused(),
                       .refusal = m_feed.lastRefusal()};
    if (m_feed.last()) {
        status.position.name = m_feed.last()->name;
        status.position.place = m_feed.last()->site;
    }
    if (usable) {
        const orbit::LookAngles seen = orbit::Observer(view.profile.site.place()).look(m_feed.at(view.now));
        status.position.direction = seen.direction;
        status.position.kilometres = seen.kilometres;
    } else if (status.permissions.allows(Action::FollowPosition)) {
        status.permissions.refuse(Action::FollowPosition,
                                  Text::tr("No position to track: %1").arg(usable.error().text));
    }
    if (m_followed) {
        status.position.phase = m_stale.isWaiting() ? PositionPhase::Stale : PositionPhase::Following;
        status.tracked =
            TrackedTarget{.name = status.position.name.isEmpty() ? Text::tr("Position") : status.position.name,
                          .isUp = status.position.direction && status.position.direction->elevation > Angle{}};
    }
}

}  // namespace boresight::sources
