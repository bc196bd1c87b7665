// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/calibration_alarms.h"

#include "core/base/text.h"
#include "core/units/angle_between.h"

#include <algorithm>

namespace boresight {
namespace {

// Causes of the alarms.
const QString kCause = QStringLiteral("calibration");
const QString kAtSun = QStringLiteral("calibration.sun");
const QString kFileCause = QStringLiteral("calibrations");
// A beam that is sharper than this gathers the Sun's light in the feed, or beside it.
constexpr Angle kNearSun = Angle::fromDegrees(1.0);
// The alarm must not come and go with the noise of an encoder.
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
    return m_control.alarms().active(kAtSun);
}

void CalibrationAlarms::warnOfOtherMount()
{
    const QString what = m_model.otherMount();
    if (what.isEmpty()) {
        m_control.alarms().clear(kCause);
        return;
    }
    m_control.alarms().raise(kCause, Severity::Warning,
                             {.what = what,
                              .action = Text::tr("It stays in force; nothing moves"),
                              .remedy = Text::tr("Find north anew and apply it, or take the calibration back")});
}

void CalibrationAlarms::warnOfFile()
{
    if (m_file.problem().isEmpty()) {
        m_control.alarms().clear(kFileCause);
        return;
    }
    m_control.alarms().raise(
        kFileCause, Severity::Warning,
        {.what = m_file.problem(),
         .action = Text::tr("What is applied is in force; its history is kept in memory only"),
         .remedy = Text::tr("Check the disk, or choose another folder with --state-dir; else it cannot be taken back "
                            "after the program was ended")});
}

// Led there, or standing there whoever has led it; what only passes by is not told.
bool CalibrationAlarms::beamAtSun()
{
    if (m_follower.follows(ephemeris::Body::Sun)) {
        return true;
    }
    const auto sun = m_follower.direction(ephemeris::Body::Sun);
    if (!sun || sun->elevation < Angle{} || m_profile.sun.keepAway == profile::KeepAway::On) {
        return false;  // its keep-out has an alarm of its own
    }
    const bool told = isAtSun();
    const auto beam = m_control.direction();
    if (!beam) {
        return told;  // and nothing else is known
    }
    const Angle distance = angleBetween(*beam, *sun);
    const Angle near = std::max(m_profile.mount.beamWidth / 2.0, kNearSun);
    return told ? distance < near + kClearOfSun : distance < near && m_axes.standStill();
}

void CalibrationAlarms::warnOfSun()
{
    if (!beamAtSun()) {
        m_control.alarms().clear(kAtSun);
        return;
    }
    m_control.alarms().raise(
        kAtSun, Severity::Warning,
        {.what = Text::tr("the beam is at the Sun, or led there"),
         .action = m_follower.follows(ephemeris::Body::Sun)
                       ? Text::tr("The mount follows the Sun until something else is asked of it")
                       : Text::tr("That lasts until the mount is moved or the Sun has passed"),
         .remedy = Text::tr("Never look along the beam, nor through a sight tube without a solar filter; a dish "
                            "gathers the Sun's heat in the feed: cover it, or be quick")});
}

}  // namespace boresight
