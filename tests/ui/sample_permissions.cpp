// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_permissions.h"

#include "core/control/beam_report.h"
#include "core/north/calibration_gates.h"
#include "core/pointing/pointing_model.h"

#include <memory>

namespace boresight::samples {

Permissions permitted()
{
    Permissions may = Permissions::all();
    may.fastestJog = profile::JogSettings().fast;
    return may;
}

Permissions withoutMoves(const QString& why, Permissions may)
{
    for (const Action action : {Action::Move, Action::JogUp, Action::JogDown, Action::JogLeft, Action::JogRight}) {
        may.refuse(action, why);
    }
    return withoutPointing(why, may);
}

Permissions withoutMotion(const QString& why, Permissions may)
{
    may.refuse(Action::Hold, why);
    return withoutMoves(why, may);
}

Permissions withoutPointing(const QString& why, Permissions may)
{
    for (const Action action :
         {Action::Point, Action::Park, Action::Home, Action::Horizon, Action::Unwind, Action::StepUp, Action::StepDown,
          Action::StepLeft, Action::StepRight, Action::ProveCrashStop}) {
        may.refuse(action, why);
    }
    return may;
}

Permissions inMotion(Permissions may)
{
    for (const Action action : {Action::SetAzimuth, Action::SetElevation, Action::ReadDrives, Action::SwitchOff,
                                Action::SwitchOffAzimuth, Action::SwitchOffElevation, Action::ReleaseBus,
                                Action::ProveCrashStop, Action::Reconnect, Action::TypeLine, Action::MakeHomeRun}) {
        may.refuse(action, QStringLiteral("The mount moves. Stop it first."));
    }
    return may;
}

StationStatus judged(StationStatus status)
{
    // A station without a calibration desk has the permissions of one without any calibration.
    const auto known = status.calibration;
    if (!known) {
        status.calibration = std::make_shared<const CalibrationStatus>();
    }
    judgeCalibration(status);
    status.calibration = known;
    if (!status.trim) {
        status.permissions.refuse(Action::ClearTrim, QStringLiteral("The target has no trim."));
    }
    addBeam(status, pointing::PointingModel(status.profile->pointing));
    return status;
}

}  // namespace boresight::samples
