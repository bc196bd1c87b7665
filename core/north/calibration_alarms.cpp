// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/calibration_alarms.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/units/angle_between.h"

#include <algorithm>

namespace boresight {
namespace {

// Within this angle of the Sun a dish focuses sunlight on or near its feed, even if its beam is narrower.
constexpr Angle kNearSun = Angle::fromDegrees(1.0);
// Keeps the alarm from coming and going with the noise of an encoder.
constexpr Angle kClearOfSun = Angle::fromDegrees(0.05);

}  // namespace

void CalibrationAlarms::update()
{
    warnOfOtherMount();
    warnOfFile();
    warnOfSun();
}

bool CalibrationAlarms::isAtSun() const
{
    return m_control.alarms().active(alarmEntry("sun.followed"));
}

void CalibrationAlarms::warnOfOtherMount()
{
    const QString what = m_model.otherMount();
    if (what.isEmpty()) {
        m_control.alarms().clear(alarmEntry("calibration.other-mount"));
        return;
    }
    m_control.alarms().raise(alarmEntry("calibration.other-mount"), {what});
}

void CalibrationAlarms::warnOfFile()
{
    if (m_file.problem().isEmpty()) {
        m_control.alarms().clear(alarmEntry("calibration.not-stored"));
        return;
    }
    m_control.alarms().raise(alarmEntry("calibration.not-stored"), {m_file.problem()});
}

// The beam was moved to the Sun by a calibration, or stands there for any reason. A beam that only passes the Sun is
// not reported.
bool CalibrationAlarms::beamAtSun()
{
    if (m_follower.follows(ephemeris::Body::Sun)) {
        return true;
    }
    const auto sun = m_follower.direction(ephemeris::Body::Sun);
    if (!sun || sun->elevation < Angle{} || m_profile->sun.keepAway == profile::KeepAway::On) {
        return false;  // the keep-out around the Sun has its own alarm
    }
    const bool told = isAtSun();
    const auto beam = m_control.direction();
    if (!beam) {
        return told;  // the direction of the beam is unknown, so the alarm stays as it is
    }
    const Angle distance = angleBetween(*beam, *sun);
    const Angle near = std::max(m_control.antenna().beamWidth / 2.0, kNearSun);
    return told ? distance < near + kClearOfSun : distance < near && m_axes.standStill();
}

void CalibrationAlarms::warnOfSun()
{
    if (!beamAtSun()) {
        m_control.alarms().clear(alarmEntry("sun.followed"));
        return;
    }
    m_control.alarms().raise(alarmEntry("sun.followed"),
                             {m_follower.follows(ephemeris::Body::Sun)
                                  ? Text::tr("The mount tracks the Sun until you command another motion")
                                  : Text::tr("This lasts until the mount moves or the Sun has passed")});
}

}  // namespace boresight
