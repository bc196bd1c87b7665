// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/calibration_gates.h"

#include "core/base/text.h"
#include "core/north/sky_bodies.h"

#include <algorithm>
#include <initializer_list>

namespace boresight {
namespace {

QString firstOf(std::initializer_list<QString> reasons)
{
    const auto found = std::ranges::find_if(reasons, [](const QString& reason) { return !reason.isEmpty(); });
    return found == reasons.end() ? QString() : *found;
}

QString otherRun(const CalibrationStatus& calibration)
{
    return calibration.progress.run == CalibrationRun::None ? QString()
                                                            : Text::tr("A calibration is running. End it first.");
}

void judgeMotions(const StationStatus& status, Permissions& may)
{
    const CalibrationRun run = status.calibration->progress.run;
    const bool moves = run == CalibrationRun::Swing || run == CalibrationRun::CrossScan;
    if (status.state != StationState::Calibrate || !moves) {
        return;
    }
    for (const Action action :
         {Action::Move,         Action::Point,      Action::Park,           Action::Home,      Action::Horizon,
          Action::Unwind,       Action::JogUp,      Action::JogDown,        Action::JogLeft,   Action::JogRight,
          Action::StepUp,       Action::StepDown,   Action::StepLeft,       Action::StepRight, Action::SetAzimuth,
          Action::SetElevation, Action::ReleaseBus, Action::ProveCrashStop, Action::Reconnect, Action::TypeLine,
          Action::MakeHomeRun}) {
        may.refuse(action, otherRun(*status.calibration));
    }
}

void judgeBody(const CalibrationStatus& calibration, ephemeris::Body body, const QString& point, Permissions& may)
{
    const QString other = otherRun(calibration);
    const auto now = std::ranges::find(calibration.bodies, body, &BodyNow::body);
    const bool known = now != calibration.bodies.end();
    const QString unknown = known ? QString() : Text::tr("The position of the %1 is unknown.").arg(bodyName(body));
    const auto follow = [&](bool overTheTop) {
        const QString obstacle = !known ? QString() : overTheTop ? now->obstacleOverTheTop : now->obstacle;
        may.refuse(followAction(body, overTheTop), firstOf({other, point, calibration.noSite, unknown, obstacle}));
    };
    follow(false);
    follow(true);
    const QString first = Text::tr("Track the %1 first.").arg(bodyName(body));
    const bool meant = calibration.body == body;
    may.refuse(actionOf(Action::TakeSun, body), meant ? firstOf({other, calibration.pointObstacle}) : first);
    may.refuse(actionOf(Action::ScanSun, body),
               firstOf({may.reason(followAction(body, calibration.overTheTop)),
                        calibration.following && meant ? QString() : first, calibration.noRoom}));
}

void judgeProposal(const CalibrationStatus& calibration, Permissions& may)
{
    const QString none = calibration.proposal ? QString() : Text::tr("Nothing is proposed yet.");
    const QString other = otherRun(calibration);
    may.refuse(Action::DiscardCalibration, none);
    may.refuse(Action::ApplyCalibration, calibration.proposal ? calibration.proposal->obstacle : none);
    may.refuse(Action::UndoCalibration, calibration.canUndo ? firstOf({other, calibration.undoObstacle})
                                                            : Text::tr("There is no calibration to undo."));
    may.refuse(Action::RedoCalibration, calibration.canRedo ? firstOf({other, calibration.redoObstacle})
                                                            : Text::tr("There is no calibration to redo."));
}

// The actions of the calibration follow one another.
void refuseAll(Permissions& may, const QString& why)
{
    for (int action = static_cast<int>(Action::AverageSensor); action <= static_cast<int>(Action::RedoCalibration);
         ++action) {
        may.refuse(static_cast<Action>(action), why);
    }
}

}  // namespace

QString whyNoCalibration(const profile::Profile& profile)
{
    return profile.pointing.geometry.kind == pointing::Geometry::XY
               ? Text::tr(
                     "An X/Y mount cannot be calibrated here. The profile has the direction of its X axis "
                     "(mount.x_axis_deg) and the zero of each axis.")
               : QString();
}

void judgeCalibration(StationStatus& status)
{
    const CalibrationStatus& calibration = *status.calibration;
    Permissions& may = status.permissions;
    if (const QString why = whyNoCalibration(*status.profile); !why.isEmpty()) {
        refuseAll(may, why);
        return;
    }
    const QString point = may.reason(Action::Point);
    const QString other = otherRun(calibration);
    judgeMotions(status, may);
    may.refuse(Action::AverageSensor, firstOf({other, calibration.sensorObstacle, calibration.averageObstacle}));
    may.refuse(Action::Swing, firstOf({other, point, calibration.swingPlan.obstacle}));
    may.refuse(Action::GivePower, calibration.wantsPower ? QString() : Text::tr("No scan waits for a power value."));
    may.refuse(Action::TakeKnownPoint, firstOf({other, calibration.knownPointObstacle}));
    may.refuse(Action::ChangePoints, calibration.points.empty() ? Text::tr("There are no points.") : other);
    may.refuse(Action::ProposeTerms, other);
    for (const ephemeris::Body body : kBodies) {
        judgeBody(calibration, body, point, may);
    }
    judgeProposal(calibration, may);
}

}  // namespace boresight
