// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl for the operator's desk: trim, settings, single alarms.
#include "core/base/text.h"
#include "core/control/station_control.h"
#include "core/profile/setting.h"

namespace boresight {
namespace {

Result<> makesSense(const profile::Profile& profile)
{
    const auto problems = profile::problemsOf(profile);
    if (!problems.empty()) {
        return failure(ErrorCode::InvalidInput, problems.front().key + ": " + problems.front().text);
    }
    return {};
}

}  // namespace

Result<> StationControl::handle(const request::ClearTrim&, const Source& source)
{
    return operatorOnly(source).map([&] {
        if (m_motion.trim() != AxisPosition{}) {
            m_helm.setTrim({}, source);
        }
    });
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
        m_firstMoves.beginAnew();  // the small way begins where the mount stands now
    }
    m_profile = profile;
    m_region.profileChanged(redrawn);
    for (const Axis axis : kAxes) {
        m_motion.setLimits(axis, profile.axis(axis).limits);
    }
    m_drives.setProfile(profile);
    m_arming.setProfile(profile);
    for (DriveWatch& watch : m_watches) {
        watch.setProfile(profile);
    }
    m_adviceAlarms.update(profile);
}

void StationControl::watchFirstMoves()
{
    if (m_firstMoves.exceeded(parts())) {
        m_log.add(Severity::Advisory, m_current.commander().name,
                  Text::tr("jog ends: no farther than 2° until the directions of the axes are confirmed"));
        holdHere(Activity::Holding);
    }
}

}  // namespace boresight
