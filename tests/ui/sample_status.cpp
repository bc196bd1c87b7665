// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_status.h"

#include <cmath>

namespace boresight::samples {

namespace {

constexpr UtcTime kUtc = std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} + std::chrono::hours(17) +
                         std::chrono::minutes(5) + std::chrono::seconds(59);

AxisStatus axis(Angle at, TravelRange travel)
{
    AxisStatus axis;
    axis.state = AxisState::Holding;
    axis.actual = at;
    axis.rate = 0_deg_s;
    axis.age = std::chrono::milliseconds(12);
    axis.commanded = at;
    axis.target = at;
    axis.travel = travel;
    axis.busVoltage = 24.1;
    axis.boardTemperature = 38.0;
    axis.torque = 1.25;
    axis.current = 2.1;
    axis.mode = 10;
    return axis;
}

void place(StationStatus& status, AxisPosition actual, AxisPosition commanded, AxisPosition target)
{
    status.azimuth.actual = actual.azimuth;
    status.azimuth.commanded = commanded.azimuth;
    status.azimuth.target = target.azimuth;
    status.elevation.actual = actual.elevation;
    status.elevation.commanded = commanded.elevation;
    status.elevation.target = target.elevation;
    const auto sky = [](const AxisPosition& at) { return SkyPointing{at.azimuth.wrapped360(), at.elevation}; };
    status.actual = sky(actual);
    status.commanded = sky(commanded);
    status.target = sky(target);
}

using survey::ProtectionLine;
using survey::Verdict;

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
    {"id.id", "1", "2", nullptr, Verdict::Right, "Two drives with one address answer as one"},
    {"servopos.position_min", "-0.258", "-0.008", "-0.010", Verdict::Dangerous,
     "The drive's own lower limit: the second, independent guard of the cable. Wanted is the travel of the profile and "
     "a margin of 3°"},
    {"servopos.position_max", "1.258", "0.258", "0.010", Verdict::Dangerous,
     "The drive's own upper limit: outside it the drive refuses to hold, and a fault lets the axis go"},
    {"servo.default_timeout_s", "0.1 s", nullptr, "0.1 s", Verdict::Right, "How soon the drive notices silence"},
    {"servo.timeout_mode", "10 hold", nullptr, "12 damp", Verdict::Dangerous,
     "A drive that is not fed only damps: an unbalanced elevation creeps down, a wound cable turns back. With 10 it "
     "slows down and holds"},
    {"servo.timeout_max_torque_Nm", "5.0 Nm", nullptr, "5.0 Nm", Verdict::Right, "Torque while it is not fed"},
    {"servo.max_current_A", "20 A", nullptr, "100 A", Verdict::Advised,
     "The factory limit is that of the board, not of the motor and the supply"},
    {"servo.max_voltage", "46 V", nullptr, "46 V", Verdict::Right, "Braking pumps the supply"},
    {"servo.default_velocity_limit", "0.017 /s", nullptr, "nan", Verdict::Advised,
     "Used when a command names no limit"},
    {"servo.default_accel_limit", "0.008 /s²", nullptr, "nan", Verdict::Dangerous,
     "Without it the stop after a time-out is a hard one"},
    {"motor_position.rotor_to_output_ratio", "0.0066667", nullptr, "1.0", Verdict::Dangerous,
     "The gear of the profile: a drive that knows another turns 150 times too far"},
};

std::vector<ProtectionLine> protections(Axis axis, bool factory)
{
    std::vector<ProtectionLine> lines;
    for (const Setting& setting : kSettings) {
        const bool own = axis == Axis::Elevation && setting.wantedElevation != nullptr;
        const QString wanted = QString::fromUtf8(own ? setting.wantedElevation : setting.wanted);
        const bool differs = factory && setting.factory != nullptr;
        lines.push_back({.key = QLatin1String(setting.key),
                         .wanted = wanted,
                         .found = differs ? QString::fromUtf8(setting.factory) : wanted,
                         .reason = QString::fromUtf8(setting.reason),
                         .verdict = differs ? setting.verdict : Verdict::Right});
    }
    return lines;
}

DriveStatus drive(Axis axis)
{
    DriveStatus drive;
    const bool azimuth = axis == Axis::Azimuth;
    drive.id = azimuth ? 1 : 2;
    drive.identity = {.uuid = azimuth ? QStringLiteral("3f2a9c1d-77b0-4e0c-9a52-5b1d20c4e811")
                                      : QStringLiteral("a07e4410-2c5f-4b6d-8f3e-90d1c2b7a5f4"),
                      .firmware = QStringLiteral("1.1.0"),
                      .registerMap = 5};
    drive.protections = protections(axis, false);
    drive.turnKnown = true;
    drive.crashStop = memory::CrashStop{.drive = drive.identity.uuid,
                                        .rate = 2_deg_s,
                                        .angle = azimuth ? 0.21_deg : 0.16_deg,
                                        .time = std::chrono::milliseconds(azimuth ? 140 : 120),
                                        .when = kUtc - std::chrono::minutes(306)};
    return drive;
}

// Rises at 285°, culminates at 62° in the north, sets at 75°: azimuth goes on through north to 435°.
AxisPosition passAt(double seconds)
{
    const double phase = std::clamp(seconds / kPassLength, 0.0, 1.0);
    const double across = 1.0 / (1.0 + std::exp(-(phase - 0.5) * 11.0));
    const double height = std::sin(phase * std::numbers::pi);
    return {.azimuth = 285_deg + 150_deg * across, .elevation = 3_deg + 59_deg * height * height};
}

void dropTarget(StationStatus& status)
{
    status.target.reset();
    status.azimuth.target.reset();
    status.elevation.target.reset();
    status.targetText.clear();
}

void addAlarm(StationStatus& status, Severity severity, const QString& what, const QString& action,
              const QString& remedy)
{
    Alarm alarm;
    alarm.id = status.alarms.size() + 1;
    alarm.severity = severity;
    alarm.what = what;
    alarm.action = action;
    alarm.remedy = remedy;
    alarm.since = kUtc - std::chrono::seconds(7);
    status.alarms.push_back(alarm);
}

}  // namespace

StationStatus idle()
{
    StationStatus status;
    status.state = StationState::Parked;
    status.stateReason = QStringLiteral("park position reached");
    status.azimuth = axis(0_deg, {-90_deg, 450_deg});
    status.elevation = axis(0_deg, {0_deg, 90_deg});
    place(status, {}, {}, {});
    status.targetText = QStringLiteral("park");
    status.commander = {SourceKind::Operator, 0, QStringLiteral("operator")};
    status.bus.state = LinkState::Up;
    status.bus.sent = 120'344;
    status.bus.received = 120'344;
    status.busName = QStringLiteral("simulated");
    status.simulated = true;
    status.listening = QStringLiteral("127.0.0.1:4533");
    status.utc = kUtc;
    status.drives.survey = survey::SurveyState::Done;
    status.drives.switchedOn = true;
    status.drives.azimuth = drive(Axis::Azimuth);
    status.drives.elevation = drive(Axis::Elevation);
    return withClients(status, 1);
}

StationStatus tracking(double seconds)
{
    StationStatus status = idle();
    status.state = StationState::Track;
    status.stateReason = QStringLiteral("rotctld client sends targets");
    place(status, passAt(seconds), passAt(seconds + 0.05), passAt(seconds + 0.6));
    status.azimuth.state = AxisState::Moving;
    status.elevation.state = AxisState::Moving;
    status.targetText = QStringLiteral("P %1 %2")
                            .arg(status.target->azimuth.degrees(), 0, 'f', 2)
                            .arg(status.target->elevation.degrees(), 0, 'f', 2);
    status.commander = {SourceKind::Client, 1, QStringLiteral("rotctld 127.0.0.1:51234")};
    status.clients.front().driving = true;
    status.utc = kUtc + std::chrono::milliseconds(static_cast<int>(seconds * 1000.0));
    return status;
}

StationStatus stopped()
{
    StationStatus status = tracking(200.0);
    status.state = StationState::Stopped;
    status.stopLatched = true;
    status.stateReason = QStringLiteral("STOP pressed by operator");
    status.azimuth.state = AxisState::Stopped;
    status.elevation.state = AxisState::Stopped;
    dropTarget(status);
    return status;
}

StationStatus faulted()
{
    StationStatus status = tracking(240.0);
    status.state = StationState::Fault;
    status.stateReason = QStringLiteral("azimuth drive: over temperature");
    status.azimuth.state = AxisState::Fault;
    status.azimuth.stateText = QStringLiteral("over temperature (38)");
    status.azimuth.mode = 1;
    status.azimuth.faultCode = 38;
    status.elevation.state = AxisState::Holding;
    addAlarm(status, Severity::Alarm, QStringLiteral("Azimuth drive fault 38: over temperature, 81 °C"),
             QStringLiteral("Azimuth is off, elevation holds"),
             QStringLiteral("Let the drive cool below 60 °C, then press Re-arm"));
    addAlarm(status, Severity::Warning, QStringLiteral("Azimuth torque limited by temperature"),
             QStringLiteral("Speed reduced"), QStringLiteral("Wait"));
    return status;
}

StationStatus disconnected()
{
    StationStatus status = withAge(tracking(150.0), std::chrono::milliseconds(3400));
    status.state = StationState::Disconnected;
    status.stateReason = QStringLiteral("no reply from azimuth and elevation");
    status.azimuth.state = AxisState::NoData;
    status.elevation.state = AxisState::NoData;
    status.bus.state = LinkState::Lost;
    status.bus.text = QStringLiteral("can0 is gone: plug the adapter in again");
    status.simulated = false;
    addAlarm(status, Severity::Alarm, QStringLiteral("No reply from azimuth and elevation"),
             QStringLiteral("The drives stop by their own watchdog (0.1 s)"),
             QStringLiteral("Check cable and supply; Re-arm when they answer"));
    return status;
}

StationStatus limited()
{
    StationStatus status = tracking(300.0);
    status.elevation.travel = {10_deg, 85_deg};
    status.azimuth.travel = {-150_deg, 150_deg};
    place(status, {150_deg, 10_deg}, {150_deg, 10_deg}, {150_deg, 10_deg});
    status.azimuth.state = AxisState::Limit;
    status.azimuth.stateText = QStringLiteral("at travel limit 150.0°");
    status.elevation.state = AxisState::Limit;
    status.targetText = QStringLiteral("P 171.25 -2.40");
    status.limited = true;
    addAlarm(status, Severity::Warning, QStringLiteral("Target outside the limits"),
             QStringLiteral("The nearest permitted point is driven"), QStringLiteral("None needed"));
    status.alarms.back().acknowledged = true;
    return status;
}

StationStatus operatorMoving()
{
    StationStatus status = tracking(20.0);
    status.state = StationState::Slew;
    status.stateReason = QStringLiteral("go to 113.0° 10.0°");
    place(status, {62_deg, 24_deg}, {64.5_deg, 23_deg}, {113_deg, 10_deg});
    status.targetText = QStringLiteral("go to 113.0° 10.0°");
    status.commander = {SourceKind::Operator, 0, QStringLiteral("operator")};
    status.authority = Authority::Operator;
    return status;
}

StationStatus factoryDrives()
{
    StationStatus status = idle();
    status.state = StationState::Standby;
    status.stateReason = QStringLiteral("protections are wrong");
    status.azimuth.state = AxisState::Off;
    status.elevation.state = AxisState::Off;
    dropTarget(status);
    status.drives.switchedOn = false;
    status.drives.armingObstacle =
        QStringLiteral("5 settings of each drive are dangerous, first: azimuth servopos.position_min");
    for (const Axis axis : {Axis::Azimuth, Axis::Elevation}) {
        DriveStatus& one = axis == Axis::Azimuth ? status.drives.azimuth : status.drives.elevation;
        one.protections = protections(axis, true);
        one.crashStop.reset();
    }
    return status;
}

StationStatus reading()
{
    StationStatus status = factoryDrives();
    status.drives.survey = survey::SurveyState::Running;
    status.drives.surveyText = QStringLiteral("reading servo.timeout_mode of elevation");
    status.drives.armingObstacle = QStringLiteral("the drives are being read");
    for (ProtectionLine& line : status.drives.elevation.protections) {
        line.verdict = Verdict::Unread;
        line.found.clear();
    }
    status.drives.azimuth.turnKnown = false;
    status.drives.elevation.turnKnown = false;
    return status;
}

StationStatus released()
{
    StationStatus status = withAge(idle(), std::chrono::milliseconds(9000));
    status.state = StationState::Disconnected;
    status.stateReason = QStringLiteral("bus released to other tools");
    status.bus.state = LinkState::Closed;
    status.azimuth.state = AxisState::NoData;
    status.elevation.state = AxisState::NoData;
    dropTarget(status);
    status.drives.released = true;
    status.drives.switchedOn = false;
    status.drives.survey = survey::SurveyState::NotDone;
    return status;
}

StationStatus proving()
{
    StationStatus status = idle();
    status.state = StationState::Calibrate;
    status.stateReason = QStringLiteral("crash-stop proof");
    place(status, {31.4_deg, 20_deg}, {31.45_deg, 20_deg}, {34_deg, 20_deg});
    status.azimuth.state = AxisState::Moving;
    dropTarget(status);
    status.drives.proofRunning = true;
    status.drives.proofText = QStringLiteral("azimuth at 2.0°/s, not fed since 0.3 s");
    status.drives.elevation.crashStop.reset();
    return status;
}

StationStatus asking(Axis axis, int places, Angle period, bool proposed)
{
    StationStatus status = idle();
    status.state = StationState::Standby;
    status.stateReason = QStringLiteral("the turn is not known");
    place(status, {45.1_deg, 20_deg}, {45.1_deg, 20_deg}, {45.1_deg, 20_deg});
    dropTarget(status);
    const Angle at = axis == Axis::Azimuth ? 45.1_deg : 20_deg;
    memory::TurnQuestion question;
    for (int place = 0; place < places; ++place) {
        question.candidates.push_back(at + period * (place - places / 4));
    }
    if (proposed) {
        question.proposed = at;
    }
    question.period = period;
    question.evidence = {
        QStringLiteral("The record says 44.8°, 2026-11-20 21:14Z, written while the axis moved"),
        QStringLiteral("The drive lost power since: it counts its turns anew"),
        QStringLiteral("The drive reports 45.1° within one turn of its encoder"),
    };
    DriveStatus& one = axis == Axis::Azimuth ? status.drives.azimuth : status.drives.elevation;
    one.turnKnown = false;
    one.turnQuestion = question;
    return status;
}

StationStatus withAge(StationStatus status, std::chrono::milliseconds age)
{
    status.azimuth.age = age;
    status.elevation.age = age;
    return status;
}

StationStatus withClients(StationStatus status, int count)
{
    status.clients.clear();
    for (int i = 0; i < count; ++i) {
        ClientStatus client;
        client.id = static_cast<std::uint64_t>(i + 1);
        client.address = QStringLiteral("127.0.0.1:%1").arg(51234 + i);
        client.program = i == 0 ? QStringLiteral("Gpredict") : QString();
        client.lastCommand = QStringLiteral("P 339.50 57.00");
        status.clients.push_back(client);
    }
    return status;
}

StationUpdate update(const StationStatus& status)
{
    StationUpdate update;
    update.status = status;
    return update;
}

StationUpdate refusal(const StationStatus& status, std::uint64_t requestId, const char* reason)
{
    StationUpdate refused = update(status);
    refused.answers.push_back({requestId, Error{ErrorCode::Refused, reason}});
    return refused;
}

StationUpdate acceptance(const StationStatus& status, std::uint64_t requestId)
{
    StationUpdate accepted = update(status);
    accepted.answers.push_back({requestId, std::nullopt});
    return accepted;
}

LogEntry logEntry(std::uint64_t number, Severity severity, const QString& source, const QString& text)
{
    return {number, kUtc + std::chrono::seconds(number), severity, source, text};
}

}  // namespace boresight::samples
