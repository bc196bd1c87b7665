// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_permissions.h"

#include "core/north/calibration_gates.h"
#include "core/pointing/pointing_model.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace boresight::samples {

namespace {

constexpr std::array kBoth{Axis::Azimuth, Axis::Elevation};
constexpr Angle kAtEnd = 0.05_deg;
constexpr std::chrono::seconds kOldest{1};

const AxisStatus& axisOf(const StationStatus& status, Axis axis)
{
    return axis == Axis::Azimuth ? status.azimuth : status.elevation;
}

const DrivesStatus& drivesOf(const StationStatus& status)
{
    static const DrivesStatus none;
    return status.drives ? *status.drives : none;
}

const DriveStatus& driveOf(const StationStatus& status, Axis axis)
{
    return axis == Axis::Azimuth ? drivesOf(status).azimuth : drivesOf(status).elevation;
}

QString driveName(Axis axis)
{
    return axis == Axis::Azimuth ? QStringLiteral("azimuth drive") : QStringLiteral("elevation drive");
}

QString firstOf(const QString& one, const QString& other)
{
    return one.isEmpty() ? other : one;
}

QString noMotion(const StationStatus& status)
{
    if (drivesOf(status).released) {
        return QStringLiteral("The bus is released to other tools. Take the bus back first.");
    }
    if (status.state == StationState::Disconnected) {
        return QStringLiteral("no reply from the azimuth drive");
    }
    if (drivesOf(status).proofRunning) {
        return QStringLiteral("The crash-stop proof moves the mount. End it first.");
    }
    if (status.stopLatched || status.state == StationState::Stopped) {
        return QStringLiteral("STOP is latched. Reset STOP first.");
    }
    return status.state == StationState::Fault ? QStringLiteral("%1. Re-arm first.").arg(status.stateReason)
                                               : drivesOf(status).armingObstacle;
}

QString notPlaced(const StationStatus& status, Axis axis)
{
    return axisOf(status, axis).turnKnown
               ? QString()
               : QStringLiteral("The cable wrap of the %1 is unknown. Enter where the axis is. Only slow jog works.")
                     .arg(driveName(axis));
}

bool arePlaced(const StationStatus& status)
{
    return status.azimuth.turnKnown && status.elevation.turnKnown;
}

QString noPointing(const StationStatus& status)
{
    const QString unconfirmed =
        status.profile->mount.directions == profile::Directions::Confirmed
            ? QString()
            : QStringLiteral(
                  "The directions of the axes are not confirmed. Jog each axis a little and confirm them first.");
    return firstOf(firstOf(noMotion(status), unconfirmed),
                   firstOf(notPlaced(status, Axis::Azimuth), notPlaced(status, Axis::Elevation)));
}

bool moves(const StationStatus& status)
{
    return status.state == StationState::Slew || status.state == StationState::Track ||
           status.state == StationState::Jog || status.state == StationState::Calibrate;
}

QString moving(const StationStatus& status)
{
    const bool anyAxis = status.azimuth.state == AxisState::Moving || status.elevation.state == AxisState::Moving;
    return anyAxis || moves(status) ? QStringLiteral("The mount moves. Stop it first.") : QString();
}

QString noWayOn(const StationStatus& status, Axis which, bool upwards)
{
    const AxisStatus& axis = axisOf(status, which);
    if (!axis.actual || axis.travel.max <= axis.travel.min || !axis.turnKnown) {
        return {};
    }
    if (upwards && *axis.actual > axis.travel.max - kAtEnd) {
        return QStringLiteral("at the upper limit %1°").arg(axis.travel.max.degrees(), 0, 'f', 1);
    }
    return !upwards && *axis.actual < axis.travel.min + kAtEnd
               ? QStringLiteral("at the lower limit %1°").arg(axis.travel.min.degrees(), 0, 'f', 1)
               : QString();
}

void judgeMotions(StationStatus& status)
{
    const QString motion = noMotion(status);
    const QString pointing = noPointing(status);
    Permissions& may = status.permissions;
    may.refuse(Action::Move, motion);
    may.refuse(Action::Hold, moves(status) ? QString() : motion);
    for (const Action action : {Action::Point, Action::Park, Action::Home}) {
        may.refuse(action, pointing);
    }
    const bool wound = status.azimuth.actual && abs(*status.azimuth.actual) > 180_deg;
    may.refuse(Action::Unwind, !pointing.isEmpty() ? pointing
                               : wound             ? QString()
                                       : QStringLiteral("In this direction the azimuth cable is already wound least."));
    const auto judge = [&](JogDirection direction, Axis axis, bool upwards) {
        const QString jog = firstOf(motion, noWayOn(status, axis, upwards));
        may.refuse(jogAction(direction), jog);
        may.refuse(stepAction(direction), firstOf(pointing, jog));
    };
    judge(JogDirection::Up, Axis::Elevation, true);
    judge(JogDirection::Down, Axis::Elevation, false);
    judge(JogDirection::Right, Axis::Azimuth, true);
    judge(JogDirection::Left, Axis::Azimuth, false);
    const profile::JogSettings& jog = status.profile->jog;
    const bool confirmed = status.profile->mount.directions == profile::Directions::Confirmed;
    may.fastestJog = !arePlaced(status) ? std::min(jog.slow, jog.unwind)
                     : confirmed        ? jog.fast
                                        : std::min(jog.fast, profile::kFastestUnconfirmed);
}

QString noFix(const StationStatus& status)
{
    const auto right = [&status](Axis axis) {
        return std::ranges::none_of(driveOf(status, axis).protections, differs);
    };
    if (drivesOf(status).survey != SurveyState::Done) {
        return QStringLiteral("the drives are not read yet");
    }
    if (!drivesOf(status).fixable) {
        return std::ranges::all_of(kBoth, right)
                   ? QStringLiteral("every setting is right")
                   : QStringLiteral(
                         "Fix has nothing to write. Change the marked settings by hand, as each line explains");
    }
    return drivesOf(status).switchedOn
               ? QStringLiteral(
                     "The azimuth drive is switched on. Support the elevation and switch the drives off first.")
               : QString();
}

void judgeDrives(StationStatus& status)
{
    const DrivesStatus& drives = drivesOf(status);
    const QString released =
        drives.released ? QStringLiteral("The bus is released to other tools. Take the bus back first.") : QString();
    const QString writing = drives.survey == SurveyState::Fixing
                                ? QStringLiteral("the drives' settings are being written: wait until that is done")
                                : QString();
    const QString reading =
        drives.survey == SurveyState::Running ? QStringLiteral("the drives are being read") : writing;
    const QString silent =
        status.state == StationState::Disconnected ? QStringLiteral("both drives must answer") : QString();
    const QString moves = moving(status);
    Permissions& may = status.permissions;
    may.refuse(Action::ReadDrives, firstOf(reading, firstOf(released, moves)));
    may.refuse(Action::FixDrives, firstOf(reading, firstOf(noFix(status), silent)));
    may.refuse(Action::SwitchOff, firstOf(moves, silent));
    may.refuse(Action::ReleaseBus, firstOf(writing, moves));
    may.refuse(Action::Reconnect, moves);
    may.refuse(Action::ProveCrashStop, firstOf(noPointing(status), moves));
    for (const Axis axis : kBoth) {
        const AxisStatus& now = axisOf(status, axis);
        const bool fresh = now.actual && now.age && *now.age < kOldest;
        may.refuse(setAction(axis), fresh ? firstOf(notPlaced(status, axis), moves)
                                          : QStringLiteral("no fresh position from the %1").arg(driveName(axis)));
    }
}

void judgeClients(StationStatus& status)
{
    const profile::RotctldSettings& rules = status.profile->rotctld;
    for (ClientStatus& client : status.clients) {
        if (status.stopLatched) {
            client.leadObstacle = QStringLiteral("STOP is latched. Reset STOP first.");
        } else if (rules.lead == profile::Lead::Locked && !client.locked) {
            client.leadObstacle = QStringLiteral("The mount is locked to %1. Unlock it first.")
                                      .arg(QString::fromStdString(rules.lockedTo));
        } else if (status.authority == Authority::Operator || client.readOnly) {
            client.leadObstacle.clear();
        } else if (rules.lead == profile::Lead::Last) {
            client.leadObstacle = QStringLiteral("the newest client has control");
        } else {
            client.leadObstacle = client.leading ? QStringLiteral("it has control") : QString();
        }
    }
}

void addBeam(StationStatus& status)
{
    const pointing::PointingModel model(status.profile->pointing);
    const auto add = [&](std::optional<Angle> AxisStatus::*axis, std::optional<Angle> BeamAngles::*beam) {
        const std::optional<Angle>& azimuth = status.azimuth.*axis;
        const std::optional<Angle>& elevation = status.elevation.*axis;
        const bool both = azimuth && elevation;
        const SkyPointing place = both ? model.toSky({*azimuth, *elevation}) : SkyPointing{};
        status.azimuth.beam.*beam = both ? std::optional(place.azimuth) : azimuth;
        status.elevation.beam.*beam = both ? std::optional(place.elevation) : elevation;
    };
    add(&AxisStatus::actual, &BeamAngles::actual);
    add(&AxisStatus::commanded, &BeamAngles::commanded);
    add(&AxisStatus::target, &BeamAngles::target);
}

}  // namespace

StationStatus judged(StationStatus status)
{
    const Permissions own = status.permissions;
    status.permissions = Permissions::all();
    judgeMotions(status);
    judgeDrives(status);
    judgeClients(status);
    const auto calibration = std::exchange(
        status.calibration, status.calibration ? status.calibration : std::make_shared<const CalibrationStatus>());
    judgeCalibration(status);
    status.calibration = calibration;
    for (int action = 0; action < static_cast<int>(Action::Count); ++action) {
        status.permissions.refuse(static_cast<Action>(action), own.reason(static_cast<Action>(action)));
    }
    addBeam(status);
    return status;
}

}  // namespace boresight::samples
