// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl for the operator's desk: trim, settings, single alarms.
#include "core/alarms/catalogue.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/control/station_control.h"
#include "core/profile/setting.h"

#include <utility>

namespace boresight {
namespace {

// A trim corrects a pointing error; more is another target.
constexpr Angle kLargestTrim = Angle::fromDegrees(10.0);

Result<> makesSense(const profile::Profile& profile)
{
    const auto problems = profile::problemsOf(profile);
    if (!problems.empty()) {
        return failure(ErrorCode::InvalidInput, problems.front().key + ": " + problems.front().text);
    }
    return {};
}

}  // namespace

Result<> StationControl::handle(const request::Nudge& wanted, const Source& source)
{
    if (!m_current.is(Activity::Streaming) || source.kind != SourceKind::Operator) {
        return handle(request::Step{.azimuth = wanted.azimuth, .elevation = wanted.elevation}, source);
    }
    const AxisPosition trim{.azimuth = m_motion.trim().azimuth + wanted.azimuth,
                            .elevation = m_motion.trim().elevation + wanted.elevation};
    if (!(abs(trim.azimuth) <= kLargestTrim && abs(trim.elevation) <= kLargestTrim)) {
        return failure(ErrorCode::OutOfRange, Text::tr("a trim beyond %1° is not a correction any more")
                                                  .arg(toQString(formatFixed(kLargestTrim.degrees(), 0))));
    }
    setTrim(trim, source);
    return {};
}

Result<> StationControl::handle(const request::ClearTrim&, const Source& source)
{
    return operatorOnly(source).map([&] {
        if (m_motion.trim() != AxisPosition{}) {
            setTrim({}, source);
        }
    });
}

// A stream of the operator's, as a client has one: whatever the stream is of, limits and trim hold for it alike.
Result<> StationControl::handle(const request::Follow& wanted, const Source& source)
{
    return operatorOnly(source).and_then([&] { return mayPoint(source); }).and_then([&] {
        if (wanted.anew) {
            m_motion.rest();
        }
        return streamTo(m_model.resolve(wanted.direction, heading()), wanted.direction, source, wanted.what);
    });
}

Result<> StationControl::reaches(const SkyPointing& direction) const
{
    const pointing::Resolved resolved = m_model.resolve(direction, heading());
    if (resolved.limited) {
        return failure(ErrorCode::OutOfRange, resolved.reason);
    }
    constexpr Angle kZenith = Angle::fromDegrees(90.0);
    if (direction.elevation > kZenith && resolved.position.elevation <= kZenith) {
        return failure(ErrorCode::OutOfRange,
                       Text::tr("the travel and the limits of the axes do not reach it over the top"));
    }
    return mayGoTo(resolved.position);
}

void StationControl::setTrim(const AxisPosition& trim, const Source& source)
{
    m_motion.setTrim(trim);
    m_log.add(Severity::Advisory, source.name,
              Text::tr("trims what is followed by %1° in azimuth, %2° in elevation")
                  .arg(trim.azimuth.degrees(), 0, 'f', 2)
                  .arg(trim.elevation.degrees(), 0, 'f', 2));
}

Result<> StationControl::handle(const request::AcknowledgeAlarms&, const Source&)
{
    m_alarms.acknowledgeAll();
    return {};
}

Result<> StationControl::handle(const request::AcknowledgeAlarm& wanted, const Source&)
{
    m_alarms.acknowledge(wanted.alarmId);
    return {};
}

// The station puts it into force; see setProfile().
Result<> StationControl::handle(const request::ApplyProfile& wanted, const Source& source)
{
    return operatorOnly(source).and_then([&] { return makesSense(wanted.profile); }).and_then([&] {
        return wanted.profile.pointing == m_profile.pointing ? Result<>{} : mayChangePointing();
    });
}

Result<> StationControl::handle(const request::Reconnect& wanted, const Source& source)
{
    return operatorOnly(source).and_then([this] { return gates().drivesRest(); }).and_then([&] {
        return makesSense(wanted.profile);
    });
}

// The calibration desk carries it out, and asks for the motions that it needs like everybody else.
Result<> StationControl::handle(const CalibrationRequest&, const Source& source)
{
    return operatorOnly(source);
}

void StationControl::setProfile(const profile::Profile& profile)
{
    const bool redrawn = profile.limits != m_profile.limits || profile.pointing != m_profile.pointing;
    if (profile.mount.directions != m_profile.mount.directions) {
        m_firstMoves = {};  // the small way begins where the mount stands now
    }
    m_profile = profile;
    m_sun.setProfile(profile);
    renewSun(redrawn);
    for (const Axis axis : kAxes) {
        m_motion.setLimits(axis, profile.axis(axis).limits);
    }
    m_drives.setProfile(profile);
    m_arming.setProfile(profile);
    for (DriveWatch& watch : m_watches) {
        watch.setProfile(profile);
    }
    tellAdvice();
}

void StationControl::tellAdvice()
{
    const auto advice = profile::adviceOn(m_profile);
    if (advice == m_advice) {
        return;
    }
    for (const profile::Advice& old : std::exchange(m_advice, advice)) {
        m_alarms.clear(alarmEntry("profile.advice").of(toQString(old.key)));
    }
    for (const profile::Advice& one : m_advice) {
        m_alarms.raise(alarmEntry("profile.advice").of(toQString(one.key)), {one.what, one.remedy});
    }
}

// Nobody has confirmed yet that the axes turn as the profile says.
Result<> StationControl::mayMoveFirst(const AxisRates& rates)
{
    if (m_profile.mount.directions == profile::Directions::Confirmed) {
        return {};
    }
    const AxisPosition place = m_drives.engaged() ? m_motion.place() : *m_drives.measured();
    const auto rest = [&](Axis axis, Angle from, AngularRate wanted) {
        tracking::Setpoint then = m_motion.setpoint(axis);
        then.position = from;
        then.rate = abs(then.rate) > abs(wanted) ? then.rate : wanted;
        return restingPlace(then, m_profile.axis(axis).limits);
    };
    return m_firstMoves.admits(rates, place,
                               {.azimuth = rest(Axis::Azimuth, place.azimuth, rates.azimuth),
                                .elevation = rest(Axis::Elevation, place.elevation, rates.elevation)});
}

void StationControl::watchFirstMoves()
{
    if (m_profile.mount.directions == profile::Directions::Confirmed || !m_current.runsFreely()) {
        return;
    }
    const auto rest = [this](Axis axis) { return restingPlace(m_motion.setpoint(axis), m_profile.axis(axis).limits); };
    const AxisRates rates{.azimuth = m_motion.setpoint(Axis::Azimuth).rate,
                          .elevation = m_motion.setpoint(Axis::Elevation).rate};
    if (m_drives.engaged() && m_firstMoves.exceeded(rates, {rest(Axis::Azimuth), rest(Axis::Elevation)})) {
        m_log.add(Severity::Advisory, m_current.commander().name,
                  Text::tr("jog ends: no farther than 2° until the directions of the axes are confirmed"));
        holdHere(Activity::Holding);
    }
}

}  // namespace boresight
