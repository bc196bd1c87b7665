// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/body_follower.h"

#include "core/base/text.h"
#include "core/units/angle_between.h"

#include <cmath>

namespace boresight {
namespace {

using namespace boresight::literals;
using ephemeris::Body;

const QString kFollowerSource = QStringLiteral("calibration");
constexpr std::chrono::seconds kPointPeriod{1};
// Nearer to the zenith a small offset across would need a very large change of azimuth.
constexpr Angle kHighest = Angle::fromDegrees(89.0);
// The largest change from one point to the next. Sun and Moon move 0.004° in a second.
constexpr Angle kLeap = Angle::fromDegrees(0.2);

// The same direction, for a boom past the zenith.
SkyPointing fromSide(const SkyPointing& place, bool overTheTop)
{
    return overTheTop ? SkyPointing{.azimuth = place.azimuth + 180_deg, .elevation = 180_deg - place.elevation} : place;
}

// In angles of the axes. Over the top both offsets change their sign (as in fitCrossScan).
SkyPointing beside(SkyPointing place, const calibration::SkyOffset& offset)
{
    const double shrink = std::cos(place.elevation.radians());
    const double least = std::cos(kHighest.radians());
    place.azimuth += offset.across / std::copysign(std::max(std::abs(shrink), least), shrink);
    place.elevation += offset.elevation;
    return place;
}

}  // namespace

BodyFollower::BodyFollower(StationControl& control, const profile::InForce& profile, const Clock& clock, EventLog& log)
    : m_control(control), m_clock(clock), m_log(log), m_bodies(profile->site)
{}

void BodyFollower::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (before.site != after.site) {
        m_bodies = SkyBodies(after.site);
    }
    if (!m_following) {
        return;
    }
    if (const auto may = permits(*m_body, m_overTheTop); !may) {
        end(may.error().text);  // at once: the next tick would move the mount inside the forbidden region
    }
}

Result<SkyPointing> BodyFollower::direction(Body body)
{
    const auto direction = m_bodies.direction(body, m_refraction, m_clock.utc());
    if (!direction) {
        return failure(ErrorCode::Refused, Text::tr("The profile has no site. Enter the site on the page Profile"));
    }
    return *direction;
}

Result<> BodyFollower::permits(Body body, bool overTheTop)
{
    const auto place = isTimeCertain(body).and_then([&] { return direction(body); });
    return place.and_then([&](const SkyPointing& direction) -> Result<> {
        if (direction.elevation < Angle{}) {
            return failure(ErrorCode::Refused, Text::tr("The %1 is below the horizon.").arg(bodyName(body)));
        }
        const Result<> mayFace = body == Body::Sun ? m_control.mayFaceSun() : Result<>{};
        return m_control.usesMainAntenna().and_then([&] { return mayFace; }).and_then([&] {
            return m_control.reaches(fromSide(direction, overTheTop));
        });
    });
}

Result<> BodyFollower::isTimeCertain(Body body) const
{
    if (m_clock.ahead() != Seconds(0.0)) {
        return failure(ErrorCode::Refused,
                       Text::tr("The clock of this computer was set, and Boresight still uses the old time. Press Use "
                                "new time or correct the clock before you track the %1 here.")
                           .arg(bodyName(body)));
    }
    return {};
}

Result<> BodyFollower::mayFollow(Body body, bool overTheTop)
{
    return m_control.mayPoint(calibrationSource()).and_then([&] { return permits(body, overTheTop); });
}

Result<> BodyFollower::permitsAround(Body body, const std::vector<calibration::SkyOffset>& places)
{
    const bool fromBehind = overTheTop();
    const Result<> itself = permits(body, fromBehind);
    return itself.and_then([&] { return direction(body); }).and_then([&](const SkyPointing& here) -> Result<> {
        for (const calibration::SkyOffset& place : places) {
            if (const auto may = m_control.reaches(beside(fromSide(here, fromBehind), place)); !may) {
                return failure(may.error().code,
                               Text::tr("Scan a smaller width, or scan later. Not every place around the "
                                        "%1 is permitted: %2")
                                   .arg(bodyName(body), may.error().text));
            }
        }
        return {};
    });
}

BodyNow BodyFollower::now(Body body)
{
    BodyNow now{.body = body};
    if (const auto place = direction(body)) {
        const auto may = permits(body);
        const auto mayOverTheTop = permits(body, true);
        const SkyBodies::Times times = m_bodies.times(body);
        now.direction = *place;
        now.isUp = place->elevation >= Angle{};
        now.obstacle = may ? QString() : may.error().text;
        now.obstacleOverTheTop = mayOverTheTop ? QString() : mayOverTheTop.error().text;
        now.nextRise = times.rise;
        now.nextSet = times.set;
    }
    return now;
}

Result<> BodyFollower::follow(Body body, ephemeris::Refraction refraction, bool overTheTop)
{
    return mayFollow(body, overTheTop)
        .and_then([&] { return m_control.request(request::ClearTrim{}, calibrationSource()); })
        .and_then([&] {
            m_refraction = refraction;
            m_overTheTop = overTheTop;
            m_body = body;
            m_offset = {};
            return sendPoint(true);
        })
        .map([&] {
            m_following = true;
            m_motionId = m_control.motionId();
        });
}

// Each point is checked again as an over-the-top target. Otherwise an unreachable one would be approached from the
// front.
Result<> BodyFollower::sendPoint(bool anew)
{
    m_next = m_clock.now() + kPointPeriod;
    return direction(*m_body).and_then([&](const SkyPointing& place) {
        m_place = place;
        const SkyPointing aim = beside(fromSide(place, m_overTheTop), m_offset);
        return m_control.reaches(aim).and_then([&] {
            return m_control.request(request::Follow{.direction = aim, .what = bodyName(*m_body), .anew = anew},
                                     calibrationSource());
        });
    });
}

Result<> BodyFollower::lookBeside(const calibration::SkyOffset& offset)
{
    m_offset = offset;
    return sendPoint(true);
}

void BodyFollower::tick()
{
    if (!m_following) {
        return;
    }
    if (!m_control.obeys(calibrationSource())) {
        noticeOtherCommand();
    } else if (m_clock.now() >= m_next) {
        const auto may = permits(*m_body, m_overTheTop).and_then([&] { return staysOnItsWay(); }).and_then([&] {
            return sendPoint(false);
        });
        if (!may) {
            const bool leapt = !staysOnItsWay();
            end(may.error().text);
            if (leapt) {
                m_body.reset();  // nobody has centred the body at its new place
            }
        }
    }
}

// A changed clock or site makes the computed position jump. Without this check the mount would move there by itself.
Result<> BodyFollower::staysOnItsWay()
{
    return direction(*m_body).and_then([&](const SkyPointing& place) -> Result<> {
        if (m_place && angleBetween(place, *m_place) > kLeap) {
            return failure(ErrorCode::Refused,
                           Text::tr("The computed position of the %1 jumped, so tracking stopped. Was the clock or the "
                                    "site changed? Check both, then track the %1 again.")
                               .arg(bodyName(*m_body)));
        }
        return {};
    });
}

void BodyFollower::noticeOtherCommand()
{
    m_ending.clear();
    ended(Text::tr("stopped tracking the %1, because the mount got another command").arg(bodyName(*m_body)));
}

void BodyFollower::clockWasSet()
{
    if (m_following && !m_control.obeys(calibrationSource())) {
        noticeOtherCommand();  // the mount must not be held for a motion of somebody else
    }
    if (m_body) {
        end(Text::tr("The clock of this computer was set, so tracking stopped. Check the clock, then track the %1 "
                     "again.")
                .arg(bodyName(*m_body)));
        m_body.reset();  // nobody has centred the body at the other time
    }
}

void BodyFollower::end(const QString& why)
{
    if (m_following) {
        [[maybe_unused]] const Result<> held = m_control.request(request::Hold{}, calibrationSource());
        m_ending = why;
        ended(why.isEmpty() ? Text::tr("stopped tracking the %1").arg(bodyName(*m_body)) : why);
    }
}

void BodyFollower::ended(const QString& how)
{
    if (looksBeside()) {
        m_body.reset();  // nobody has centred the body there
    }
    m_following = false;
    m_offset = {};
    m_log.add(m_ending.isEmpty() ? Severity::Advisory : Severity::Warning, kFollowerSource, how);
    [[maybe_unused]] const Result<> cleared = m_control.request(request::ClearTrim{}, calibrationSource());
}

}  // namespace boresight
