// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/motion_permission.h"

#include "ui/kit/axes.h"
#include "ui/kit/format.h"

#include <QCoreApplication>

#include <algorithm>

namespace boresight::ui {

namespace {

// Closer to the end of travel than this is at the end: five times the resolution of the screen.
constexpr Angle kAtLimit = 0.05_deg;

class MotionPermission
{
    Q_DECLARE_TR_FUNCTIONS(MotionPermission)
};

// Where the axis is at the end of its travel, the way on. On an unknown turn the numbers say nothing of that.
QString whyNotOn(const StationStatus& status, Axis which, bool upwards)
{
    const AxisStatus& axis = axisOf(status, which);
    if (!axis.actual || axis.travel.max <= axis.travel.min || !isTurnKnown(status, which)) {
        return {};
    }
    if (upwards && *axis.actual > axis.travel.max - kAtLimit) {
        return MotionPermission::tr("at the upper limit %1").arg(angleText(axis.travel.max, 1));
    }
    if (!upwards && *axis.actual < axis.travel.min + kAtLimit) {
        return MotionPermission::tr("at the lower limit %1").arg(angleText(axis.travel.min, 1));
    }
    return {};
}

}  // namespace

QString whyNoPlace(const StationStatus& status, Axis axis)
{
    const AxisStatus& now = axisOf(status, axis);
    if (!now.actual || freshness(now.age) != Freshness::Live) {
        return MotionPermission::tr("the drive does not say where the %1 is").arg(name(axis));
    }
    if (!isTurnKnown(status, axis)) {
        return MotionPermission::tr("which turn the %1 is on is not known yet").arg(name(axis));
    }
    return now.state == AxisState::Moving ? MotionPermission::tr("the mount moves: stop it first") : QString();
}

QString whyNoMotion(const StationStatus& status)
{
    switch (status.state) {
        case StationState::Disconnected:
            return status.drives.released
                       ? MotionPermission::tr("the bus is released to other tools, press \"Take bus back\" first")
                       : MotionPermission::tr("no connection to the drives");
        case StationState::Stopped:
            return MotionPermission::tr("STOP is latched, press \"Reset stop\" first");
        case StationState::Fault:
            return MotionPermission::tr("drive fault, press \"Re-arm\" first");
        case StationState::Calibrate:
            return MotionPermission::tr("a calibration is running");
        default:
            break;
    }
    return status.drives.proofRunning ? MotionPermission::tr("the crash-stop proof moves the mount")
                                      : status.drives.armingObstacle;
}

QString whyNoPointing(const StationStatus& status)
{
    const QString reason = whyNoMotion(status);
    if (!reason.isEmpty()) {
        return reason;
    }
    if (status.profile->mount.directions != profile::Directions::Confirmed) {
        return MotionPermission::tr(
            "it is not confirmed yet which way the axes turn: jog each a little and confirm it first");
    }
    for (const Axis axis : kAxes) {
        if (!isTurnKnown(status, axis)) {
            return (driveOf(status, axis).turnQuestion
                        ? MotionPermission::tr("which turn the %1 is on is not known: answer the question (Ctrl+9)")
                        : MotionPermission::tr("which turn the %1 is on is not known yet"))
                .arg(name(axis));
        }
    }
    return {};
}

QString whyNoJog(const StationStatus& status, JogDirection direction)
{
    const QString reason = whyNoMotion(status);
    if (!reason.isEmpty()) {
        return reason;
    }
    switch (direction) {
        case JogDirection::Up:
            return whyNotOn(status, Axis::Elevation, true);
        case JogDirection::Down:
            return whyNotOn(status, Axis::Elevation, false);
        case JogDirection::Right:
            return whyNotOn(status, Axis::Azimuth, true);
        case JogDirection::Left:
            return whyNotOn(status, Axis::Azimuth, false);
    }
    return {};
}

QString whyNoStep(const StationStatus& status, JogDirection direction)
{
    const QString reason = whyNoPointing(status);
    return reason.isEmpty() ? whyNoJog(status, direction) : reason;
}

AngularRate fastestJog(const StationStatus& status)
{
    const profile::JogSettings& jog = status.profile->jog;
    if (!areTurnsKnown(status)) {
        return std::min(jog.slow, jog.unwind);  // the end of the cable may be near
    }
    const bool confirmed = status.profile->mount.directions == profile::Directions::Confirmed;
    return confirmed ? jog.fast : std::min(jog.fast, profile::kFastestUnconfirmed);
}

QString whyNoUnwind(const StationStatus& status)
{
    const QString reason = whyNoPointing(status);
    if (!reason.isEmpty()) {
        return reason;
    }
    const bool wound = status.azimuth.actual && abs(*status.azimuth.actual) > 180_deg;
    return wound ? QString() : MotionPermission::tr("the azimuth cable is not wound by more than half a turn");
}

bool followsAClient(const StationStatus& status)
{
    return status.state == StationState::Track && status.commander.kind == SourceKind::Client;
}

bool isMoving(const StationStatus& status)
{
    switch (status.state) {
        case StationState::Slew:
        case StationState::Track:
        case StationState::Jog:
        case StationState::Calibrate:
            return true;
        default:
            return status.azimuth.state == AxisState::Moving || status.elevation.state == AxisState::Moving;
    }
}

}  // namespace boresight::ui
