// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/motion_permission.h"

#include "ui/format.h"

#include <QCoreApplication>

namespace boresight::ui {

namespace {

// Closer to the end of travel than this is at the end: five times the resolution of the screen.
constexpr Angle kAtLimit = 0.05_deg;

QString tr(const char* text)
{
    return QCoreApplication::translate("MotionPermission", text);
}

QString whyNotOn(const AxisStatus& axis, bool upwards)
{
    if (!axis.actual || axis.travel.max <= axis.travel.min) {
        return {};
    }
    if (upwards && *axis.actual > axis.travel.max - kAtLimit) {
        return tr("at the upper limit %1").arg(angleText(axis.travel.max, 1));
    }
    if (!upwards && *axis.actual < axis.travel.min + kAtLimit) {
        return tr("at the lower limit %1").arg(angleText(axis.travel.min, 1));
    }
    return {};
}

}  // namespace

QString whyNoMotion(const StationStatus& status)
{
    switch (status.state) {
        case StationState::Disconnected:
            return tr("no connection to the drives");
        case StationState::Stopped:
            return tr("STOP is latched, press \"Reset stop\" first");
        case StationState::Fault:
            return tr("drive fault, press \"Re-arm\" first");
        case StationState::Calibrate:
            return tr("a calibration is running");
        default:
            return {};
    }
}

QString whyNoJog(const StationStatus& status, JogDirection direction)
{
    const QString reason = whyNoMotion(status);
    if (!reason.isEmpty()) {
        return reason;
    }
    switch (direction) {
        case JogDirection::Up:
            return whyNotOn(status.elevation, true);
        case JogDirection::Down:
            return whyNotOn(status.elevation, false);
        case JogDirection::Right:
            return whyNotOn(status.azimuth, true);
        case JogDirection::Left:
            return whyNotOn(status.azimuth, false);
    }
    return {};
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
