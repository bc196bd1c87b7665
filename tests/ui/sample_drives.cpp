// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_drives.h"

#include "core/drive_check/setting_names.h"
#include "tests/ui/sample_permissions.h"
#include "tests/ui/sample_status.h"

#include <algorithm>
#include <string_view>

namespace boresight::samples {

namespace {

struct Setting
{
    const char* key;
    const char* wanted;           // of azimuth
    const char* wantedElevation;  // nullptr: the same
    const char* factory;
    Verdict verdict;  // of the factory value
    const char* reason;
};

constexpr Setting kSettings[] = {
    {"id.id", "1", "2", nullptr, Verdict::Right, "The profile has this id for this axis."},
    {"servopos.position_min", "-0.258333 turns (-93.0°)", "-0.008333 turns (-3.0°)", "-0.01 turns (-3.6°)",
     Verdict::Dangerous, "The factory limits are ±3.6°. With them every motion ends in fault 39."},
    {"servopos.position_max", "1.25833 turns (453.0°)", "0.258333 turns (93.0°)", "0.01 turns (3.6°)",
     Verdict::Dangerous, "The factory limits are ±3.6°. With them every motion ends in fault 39."},
    {"servo.timeout_mode", "10 (hold)", nullptr, "12 (damp)", Verdict::Dangerous,
     "Mode 12 only damps. Without commands a loaded elevation creeps down."},
    {"servo.default_timeout_s", "0.05 to 0.2 s", nullptr, "0.1 s", Verdict::Right,
     "After this time without a command the drive stops by itself."},
    {"servo.timeout_max_torque_Nm", "above 0 Nm", nullptr, "5 Nm", Verdict::Right,
     "Timeout mode 12 damps with this torque."},
    {"servo.max_current_A", "above 0 A", nullptr, "20 A", Verdict::Right,
     "Without current the axis falls. Without a limit the motor burns. The value is in the data sheet of the motor."},
    {"servo.max_voltage", "10 to 46 V", nullptr, "46 V", Verdict::Right,
     "Above this voltage the drive stops, so that braking energy cannot destroy the board."},
    {"servo.flux_brake_margin_voltage", "1 to 20 V", nullptr, "3 V", Verdict::Right,
     "At this distance below servo.max_voltage the motor begins to turn braking energy into heat."},
    {"servo.default_velocity_limit", "0.025 turns/s (9°/s)", nullptr, "none", Verdict::Advised,
     "The highest speed of a command that has no speed of its own. The factory sets no limit."},
    {"servo.default_accel_limit", "0.166667 turns/s² (60°/s²)", nullptr, "50 turns/s² (18000°/s²)", Verdict::Advised,
     "Without commands the drive brakes with this deceleration. Too low: the axis runs on. Too high (factory: 50 "
     "turns/s²): the stop shakes the mount."},
    {"motor_position.rotor_to_output_ratio", "0.00666667", nullptr, "1", Verdict::Dangerous,
     "the gear as the profile has it (gear_ratio, gear_in): with another one every angle is wrong. To be changed by "
     "hand only: the gains change with the square of it"},
    {"motor_position.output.sign", "1 or -1", nullptr, "1", Verdict::Right,
     "With the other sign the axis turns the other way. Then change the sign in the profile, too."},
    {"motor_position.output.reference_source", "any", nullptr, "-1", Verdict::Right,
     "-1: no encoder on the axis, so the cable wrap is unknown after power-up"},
    {"servo.fault_position_error", "0.0277778 turns (10°)", nullptr, "none", Verdict::Advised,
     "With a larger position error the drive stops with fault 49. This protects a blocked axis even without "
     "Boresight."},
    {"servo.max_position_slip", "none or ≥ 1°", nullptr, "none", Verdict::Right,
     "With a small value the wind can push the axis away."},
};

struct Brief
{
    const char* text;
    const char* angle;
};

constexpr Brief kBriefs[] = {
    {"-0.258333 turns (-93.0°)", "-93.0°"},   {"-0.008333 turns (-3.0°)", "-3.0°"},
    {"-0.01 turns (-3.6°)", "-3.6°"},         {"1.25833 turns (453.0°)", "453.0°"},
    {"0.258333 turns (93.0°)", "93.0°"},      {"0.01 turns (3.6°)", "3.6°"},
    {"0.025 turns/s (9°/s)", "9°/s"},         {"0.166667 turns/s² (60°/s²)", "60°/s²"},
    {"50 turns/s² (18000°/s²)", "18000°/s²"}, {"0.0277778 turns (10°)", "10°"},
};

QString briefOf(const QString& text)
{
    const auto* const found =
        std::ranges::find_if(kBriefs, [&text](const Brief& one) { return text == QString::fromUtf8(one.text); });
    return found == std::end(kBriefs) ? text : QString::fromUtf8(found->angle);
}

QList<ProtectionLine> protections(Axis axis, bool factory)
{
    QList<ProtectionLine> lines;
    for (const Setting& setting : kSettings) {
        const bool own = axis == Axis::Elevation && setting.wantedElevation != nullptr;
        const QString wanted = QString::fromUtf8(own ? setting.wantedElevation : setting.wanted);
        const bool byHand = setting.key == std::string_view("motor_position.rotor_to_output_ratio");
        const bool differs = setting.factory != nullptr && (factory || setting.verdict == Verdict::Right);
        const QString found = differs ? QString::fromUtf8(setting.factory) : wanted;
        lines.push_back({.key = QLatin1String(setting.key),
                         .name = drive_check::settingName(setting.key, false),
                         .wanted = wanted,
                         .found = found,
                         .wantedBrief = briefOf(wanted),
                         .foundBrief = briefOf(found),
                         .reason = QString::fromUtf8(setting.reason),
                         .fix = differs && setting.verdict != Verdict::Right && !byHand ? wanted : QString(),
                         .verdict = differs ? setting.verdict : Verdict::Right});
    }
    return lines;
}

}  // namespace

DriveStatus drive(Axis axis)
{
    DriveStatus drive;
    const bool azimuth = axis == Axis::Azimuth;
    drive.id = azimuth ? 1 : 2;
    drive.identity = {.uuid = azimuth ? QStringLiteral("3f2a9c1d-77b0-4e0c-9a52-5b1d20c4e811")
                                      : QStringLiteral("a07e4410-2c5f-4b6d-8f3e-90d1c2b7a5f4"),
                      .firmware = QStringLiteral("1.1.0"),
                      .registerMap = 5};
    drive.readings = {.motorTurns = azimuth ? 0.31375 : 0.05556,
                      .motorTurnsPerSecond = azimuth ? -0.00125 : 0.0,
                      .torque = azimuth ? 1.25 : -2.4,
                      .qCurrent = azimuth ? 2.1 : -4.0,
                      .dCurrent = 0.0,
                      .busVoltage = 24.1,
                      .boardTemperature = 38.0,
                      .power = azimuth ? 6.2 : 11.8,
                      .mode = QStringLiteral("position (10)"),
                      .fault = QStringLiteral("none"),
                      .age = std::chrono::milliseconds(12),
                      .sent = 30451,
                      .answered = azimuth ? 30451u : 30439u};
    drive.protections = protections(axis, false);
    drive.registers = QStringLiteral("moteus mode 10, fault 0");
    drive.crashStop = CrashStop{.drive = drive.identity.uuid,
                                .rate = 2_deg_s,
                                .angle = azimuth ? 0.21_deg : 0.16_deg,
                                .time = std::chrono::milliseconds(azimuth ? 140 : 120),
                                .when = kUtc - std::chrono::minutes(306)};
    return drive;
}

StationStatus factoryDrives()
{
    StationStatus status = idle();
    status.state = StationState::Standby;
    status.stateReason = QStringLiteral("protections are wrong");
    status.azimuth.state = AxisState::Off;
    status.elevation.state = AxisState::Off;
    dropTarget(status);
    status.drives->switchedOn = false;
    status.drives->armingObstacle =
        QStringLiteral("5 settings of each drive are unsafe. The first: azimuth lower limit");
    status.permissions = withoutMotion(status.drives->armingObstacle);
    for (const Axis axis : {Axis::Azimuth, Axis::Elevation}) {
        DriveStatus& one = axis == Axis::Azimuth ? status.drives->azimuth : status.drives->elevation;
        one.protections = protections(axis, true);
        one.crashStop.reset();
    }
    status.drives->fixable = true;
    return status;
}

StationStatus reading()
{
    StationStatus status = factoryDrives();
    status.drives->driveCheck = DriveCheckState::Running;
    status.drives->driveCheckText = QStringLiteral("reading servo.timeout_mode of elevation");
    status.drives->armingObstacle = QStringLiteral("Boresight is reading the drives. Wait a moment.");
    status.permissions = withoutMotion(status.drives->armingObstacle);
    for (const Action action : {Action::ReadDrives, Action::FixDrives, Action::SetAzimuth, Action::SetElevation}) {
        status.permissions.refuse(action, status.drives->armingObstacle);
    }
    for (ProtectionLine& line : status.drives->elevation.protections) {
        line.verdict = Verdict::Unread;
        line.found.clear();
        line.foundBrief.clear();
    }
    status.azimuth.turnKnown = false;
    status.elevation.turnKnown = false;
    return status;
}

StationStatus released()
{
    StationStatus status = withAge(idle(), std::chrono::milliseconds(9000));
    status.state = StationState::Disconnected;
    status.stateReason = QStringLiteral("bus released to other tools");
    const QString left = QStringLiteral("The bus is released to other tools. Take the bus back first.");
    status.permissions = withoutMotion(left);
    for (const Action action : {Action::ReadDrives, Action::SwitchOff, Action::SwitchOffAzimuth,
                                Action::SwitchOffElevation, Action::SetAzimuth, Action::SetElevation}) {
        status.permissions.refuse(action, left);
    }
    status.permissions.refuse(Action::FixDrives, QStringLiteral("the drives are not read yet"));
    status.line.state = MountLine::State::Closed;
    status.azimuth.state = AxisState::NoData;
    status.elevation.state = AxisState::NoData;
    dropTarget(status);
    status.drives->released = true;
    status.drives->switchedOn = false;
    status.drives->driveCheck = DriveCheckState::NotDone;
    return status;
}

StationStatus proving()
{
    StationStatus status = idle();
    status.state = StationState::Calibrate;
    status.stateReason = QStringLiteral("crash-stop test");
    status.permissions = inMotion(withoutMoves(QStringLiteral("The crash-stop test moves the mount. End it first.")));
    place(status, {31.4_deg, 20_deg}, {31.45_deg, 20_deg}, {34_deg, 20_deg});
    status.azimuth.state = AxisState::Moving;
    dropTarget(status);
    status.drives->proofRunning = true;
    status.drives->proofText = QStringLiteral("azimuth at 2.0°/s, not fed since 0.3 s");
    status.drives->elevation.crashStop.reset();
    return status;
}

StationStatus asking(Axis axis, int places, Angle period, bool proposed)
{
    StationStatus status = idle();
    status.state = StationState::Standby;
    status.stateReason = QStringLiteral("the cable wrap is unknown");
    place(status, {45.1_deg, 20_deg}, {45.1_deg, 20_deg}, {45.1_deg, 20_deg});
    dropTarget(status);
    const Angle at = axis == Axis::Azimuth ? 45.1_deg : 20_deg;
    TurnQuestion question;
    for (int place = 0; place < places; ++place) {
        question.candidates.push_back(at + period * (place - places / 4));
    }
    if (proposed) {
        question.proposed = at;
    }
    question.period = period;
    question.evidence = {
        QStringLiteral("The angle is known only to a multiple of %1°. %2 places are possible")
            .arg(period.degrees(), 0, 'f', 1)
            .arg(places),
        QStringLiteral("The journal says %1°, 14 h old, written %2")
            .arg(at.degrees(), 0, 'f', 1)
            .arg(proposed ? QStringLiteral("at rest") : QStringLiteral("while moving")),
        QStringLiteral("The drive has lost power since: it counts its turns anew"),
        QStringLiteral("There is no sensor to compare with"),
    };
    DriveStatus& one = axis == Axis::Azimuth ? status.drives->azimuth : status.drives->elevation;
    (axis == Axis::Azimuth ? status.azimuth : status.elevation).turnKnown = false;
    one.turnQuestion = question;
    const QString why =
        QStringLiteral("The cable wrap of the %1 is unknown. Enter the position of the axis. Only slow jog works.")
            .arg(axis == Axis::Azimuth ? QStringLiteral("azimuth drive") : QStringLiteral("elevation drive"));
    status.permissions = withoutPointing(why);
    status.permissions.refuse(setAction(axis), why);
    status.permissions.fastestJog = status.profile->jog.slow;
    return status;
}

}  // namespace boresight::samples
