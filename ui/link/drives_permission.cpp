// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/drives_permission.h"

#include "ui/kit/axes.h"
#include "ui/link/motion_permission.h"

#include <QCoreApplication>

#include <algorithm>

namespace boresight::ui {

namespace {

class DrivesPermission
{
    Q_DECLARE_TR_FUNCTIONS(DrivesPermission)
};

bool nothingDiffers(const StationStatus& status)
{
    return std::none_of(kAxes.begin(), kAxes.end(), [&status](Axis axis) {
        const auto& lines = driveOf(status, axis).protections;
        return std::any_of(lines.begin(), lines.end(), survey::differs);
    });
}

}  // namespace

QString whyNoReading(const StationStatus& status)
{
    if (status.drives.released) {
        return DrivesPermission::tr("the bus is released to other tools");
    }
    switch (status.drives.survey) {
        case survey::SurveyState::Running:
            return DrivesPermission::tr("the drives are being read");
        case survey::SurveyState::Fixing:
            return DrivesPermission::tr("settings are being written");
        case survey::SurveyState::NotDone:
        case survey::SurveyState::Done:
            break;
    }
    return {};
}

QString whyNoFix(const StationStatus& status)
{
    const QString reason = whyNoReading(status);
    if (!reason.isEmpty()) {
        return reason;
    }
    if (status.drives.survey != survey::SurveyState::Done) {
        return DrivesPermission::tr("the drives have not been read");
    }
    if (!status.drives.fixable) {
        return nothingDiffers(status) ? DrivesPermission::tr("every setting is right")
                                      : DrivesPermission::tr("what differs is for a person to change: select its line");
    }
    return status.drives.switchedOn
               ? DrivesPermission::tr("the drives are switched on, press \"Switch drives off\" first")
               : QString();
}

QString whyNoSwitchOff(const StationStatus& status)
{
    if (status.drives.released) {
        return DrivesPermission::tr("the bus is released to other tools");
    }
    return status.state == StationState::Disconnected ? DrivesPermission::tr("no connection to the drives") : QString();
}

QString whyNoRelease(const StationStatus& status)
{
    if (isMoving(status)) {
        return DrivesPermission::tr("the mount moves, press \"Hold\" first");
    }
    // A reading may be left in the midst, it changes nothing.
    return status.drives.survey == survey::SurveyState::Fixing ? whyNoReading(status) : QString();
}

QString whyNoProof(const StationStatus& status)
{
    const QString reason = whyNoPointing(status);
    return reason.isEmpty() && isMoving(status) ? DrivesPermission::tr("the mount moves, press \"Hold\" first")
                                                : reason;
}

}  // namespace boresight::ui
