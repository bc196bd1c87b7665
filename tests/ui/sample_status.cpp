// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_status.h"

#include <cmath>
#include <string_view>

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
    {"id.id", "1", "2", nullptr, Verdict::Right, "the profile knows this axis under this id"},
    {"servopos.position_min", "-0.258333 turns (-93.0°)", "-0.008333 turns (-3.0°)", "-0.01 turns (-3.6°)",
     Verdict::Dangerous, "the factory's ±3.6° would end every move in fault 39"},
    {"servopos.position_max", "1.25833 turns (453.0°)", "0.258333 turns (93.0°)", "0.01 turns (3.6°)",
     Verdict::Dangerous, "the factory's ±3.6° would end every move in fault 39"},
    {"servo.timeout_mode", "10 (hold)", nullptr, "12 (damp)", Verdict::Dangerous,
     "mode 12 only damps: a loaded elevation creeps down when the computer dies"},
    {"servo.default_timeout_s", "0.05 to 0.2 s", nullptr, "0.1 s", Verdict::Right,
     "after this time without an order the drive stops by itself"},
    {"servo.timeout_max_torque_Nm", "above 0 Nm", nullptr, "5 Nm", Verdict::Right,
     "the torque with which timeout mode 12 damps"},
    {"servo.max_current_A", "above 0 A", nullptr, "20 A", Verdict::Right,
     "without current the axis falls, without a limit the motor burns; the value is in the data sheet of the motor"},
    {"servo.max_voltage", "10 to 46 V", nullptr, "46 V", Verdict::Right,
     "above it the drive stops before braking energy destroys the board"},
    {"servo.flux_brake_margin_voltage", "1 to 20 V", nullptr, "3 V", Verdict::Right,
     "so far below the highest voltage the drive begins to turn braking energy into heat"},
    {"servo.default_velocity_limit", "0.025 turns/s (9°/s)", nullptr, "none", Verdict::Advised,
     "the speed of every order that names none; the factory has no limit"},
    {"servo.default_accel_limit", "0.166667 turns/s² (60°/s²)", nullptr, "50 turns/s² (18000°/s²)", Verdict::Advised,
     "with it the drive brakes when the computer dies: too low and the axis runs on, too high (the factory's 50 "
     "turns/s²) and the mount is hit hard"},
    {"motor_position.rotor_to_output_ratio", "0.00666667", nullptr, "1", Verdict::Dangerous,
     "the gear as the profile has it (gear_ratio, gear_in): with another one every angle is wrong. To be changed by "
     "hand only: the gains change with the square of it"},
    {"motor_position.output.sign", "1 or -1", nullptr, "1", Verdict::Right,
     "turned round, the axis runs the other way: the profile's sign goes with it"},
    {"motor_position.output.reference_source", "any", nullptr, "-1", Verdict::Right,
     "-1: no encoder on the axis, so the turn is not known after power-up"},
    {"servo.fault_position_error", "0.0277778 turns (10°)", nullptr, "none", Verdict::Advised,
     "second line against a jam: so far behind its order the drive gives up (fault 49) without this program"},
    {"servo.max_position_slip", "none or ≥ 1°", nullptr, "none", Verdict::Right,
     "a small one lets the axis give way to the wind instead of holding"},
};

std::vector<ProtectionLine> protections(Axis axis, bool factory)
{
    std::vector<ProtectionLine> lines;
    for (const Setting& setting : kSettings) {
        const bool own = axis == Axis::Elevation && setting.wantedElevation != nullptr;
        const QString wanted = QString::fromUtf8(own ? setting.wantedElevation : setting.wanted);
        const bool byHand = setting.key == std::string_view("motor_position.rotor_to_output_ratio");
        const bool differs = setting.factory != nullptr && (factory || setting.verdict == Verdict::Right);
        lines.push_back({.key = QLatin1String(setting.key),
                         .wanted = wanted,
                         .found = differs ? QString::fromUtf8(setting.factory) : wanted,
                         .reason = QString::fromUtf8(setting.reason),
                         .fix = differs && setting.verdict != Verdict::Right && !byHand ? wanted : QString(),
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

AxisSample sampleOf(Angle commanded, double seconds, double rate)
{
    const double noise = std::sin(seconds * 211.0) * std::sin(seconds * 37.0) + 0.5 * std::sin(seconds * 501.0);
    const double jolt = std::fmod(seconds, 97.0) < 0.04 ? 0.09 : 0.0;
    const double gust = 0.5 * std::sin(seconds / 3.1) * std::sin(seconds / 17.0);
    AxisSample sample;
    sample.commanded = commanded;
    sample.actual = commanded - Angle::fromDegrees(0.012 * rate + 0.008 * noise + 0.02 * gust + jolt);
    sample.torque = 1.2 * rate + gust + 0.08 * noise + 8.0 * jolt;
    sample.current = 1.7 * *sample.torque;
    sample.busVoltage = 24.1 - 0.15 * std::abs(*sample.torque) + 0.02 * noise;
    sample.boardTemperature = 38.0 + 4.0 * std::sin(seconds / 700.0) + 0.1 * noise;
    return sample;
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

// One object for all statuses, as the station sends it.
const std::shared_ptr<const profile::Profile>& sampleProfile()
{
    static const auto profile = [] {
        profile::Profile made;
        made.mount.beamWidth = 5_deg;
        return std::make_shared<const profile::Profile>(made);
    }();
    return profile;
}

// A mast in the east, a hill to the south, a house in the west.
const std::shared_ptr<const profile::Profile>& boundedProfile()
{
    static const auto profile = [] {
        profile::Profile made = *sampleProfile();
        made.limits.azimuth = {-60_deg, 420_deg};
        made.limits.elevation = {5_deg, 88_deg};
        made.park = {20_deg, 45_deg};
        made.limits.horizon = {{0_deg, 6_deg},    {110_deg, 6_deg},  {140_deg, 22_deg},
                               {180_deg, 28_deg}, {215_deg, 14_deg}, {240_deg, 7_deg}};
        made.limits.keepOuts = {{"mast", 62_deg, 74_deg, 0_deg, 48_deg}, {"house", 262_deg, 308_deg, 0_deg, 30_deg}};
        return std::make_shared<const profile::Profile>(made);
    }();
    return profile;
}

}  // namespace

StationStatus idle()
{
    StationStatus status;
    status.profile = sampleProfile();
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

StationStatus bounded()
{
    StationStatus status = idle();
    status.profile = boundedProfile();
    status.state = StationState::Hold;
    status.stateReason = QStringLiteral("target reached");
    place(status, {20_deg, 45_deg}, {20_deg, 45_deg}, {20_deg, 45_deg});
    status.targetText = QStringLiteral("go to 20.0° 45.0°");
    return status;
}

StationStatus routed()
{
    StationStatus status = bounded();
    status.state = StationState::Slew;
    status.stateReason = QStringLiteral("on the way to the target");
    place(status, {31_deg, 20_deg}, {33_deg, 22_deg}, {100_deg, 20_deg});
    status.route = {{62_deg, 48_deg}, {74_deg, 48_deg}, {100_deg, 20_deg}};
    status.targetText = QStringLiteral("go to 100.0° 20.0°");
    return status;
}

StationStatus cableEnding()
{
    StationStatus status = tracking(480.0);
    status.trim = SkyPointing{.azimuth = 0.3_deg, .elevation = -0.1_deg};
    status.cableEnd = CableEnd{.end = 450_deg, .in = Seconds(41.0), .turningBack = Seconds(37.0)};
    addAlarm(status, Severity::Warning, QStringLiteral("Azimuth cable ends in 58 s, at 450.0°."),
             QStringLiteral("There Boresight turns back by 360° and follows on; the target is lost for about 37 s."),
             QStringLiteral("To turn back earlier press Unwind, then give control back."));
    profile::Profile profile = *status.profile;
    profile.presets = {{"beacon", {113_deg, 10_deg}}, {"zenith", {0_deg, 90_deg}}};
    status.profile = std::make_shared<const profile::Profile>(profile);
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
    status.limitedReason = QStringLiteral("elevation -2.4° below limit 10.0°");
    addAlarm(status, Severity::Advisory, QStringLiteral("the target is outside the limits"),
             QStringLiteral("LIMITED, the nearest permitted point is driven: elevation -2.4° below limit 10.0°"),
             QStringLiteral("None needed: the mount follows on when the target comes inside"));
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
    status.drives.fixable = true;
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
        QStringLiteral("The angle is known to a multiple of %1° only: %2 places are possible")
            .arg(period.degrees(), 0, 'f', 1)
            .arg(places),
        QStringLiteral("The journal says %1°, 14 h old, written %2")
            .arg(at.degrees(), 0, 'f', 1)
            .arg(proposed ? QStringLiteral("at rest") : QStringLiteral("while moving")),
        QStringLiteral("The drive has lost power since: it counts its turns anew"),
        QStringLiteral("There is no sensor to compare with"),
    };
    DriveStatus& one = axis == Axis::Azimuth ? status.drives.azimuth : status.drives.elevation;
    one.turnKnown = false;
    one.turnQuestion = question;
    return status;
}

StationStatus freshMount()
{
    StationStatus status = idle();
    profile::Profile fresh = *status.profile;
    fresh.mount.directions = profile::Directions::Unconfirmed;
    status.profile = std::make_shared<const profile::Profile>(fresh);
    status.state = StationState::Hold;
    place(status, {10_deg, 20_deg}, {10_deg, 20_deg}, {10_deg, 20_deg});
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

StationStatus fighting()
{
    StationStatus status = withClients(tracking(330.0), 3);
    status.listening = QStringLiteral("0.0.0.0:4533");
    ClientStatus& leader = status.clients[0];
    leader = {
        .id = 1,
        .address = QStringLiteral("127.0.0.1:51234"),
        .program = QStringLiteral("Gpredict or SatDump"),
        .lastCommand = QStringLiteral("P 339.50 57.00"),
        .commandsPerSecond = 1.3,
        .driving = true,
        .leading = true,
        .advice = QStringLiteral("this Gpredict updates only every 10°: set Threshold to 0.1 in its Antenna Control")};
    status.clients[1] = {.id = 2,
                         .address = QStringLiteral("192.168.100.109:50112"),
                         .program = QStringLiteral("CQRLOG"),
                         .lastCommand = QStringLiteral("P 57 0"),
                         .commandsPerSecond = 2.0,
                         .wanting = true};
    status.clients[2] = {.id = 3,
                         .address = QStringLiteral("10.0.0.12:40007"),
                         .lastCommand = QStringLiteral("p"),
                         .commandsPerSecond = 10.0,
                         .readOnly = true};
    return status;
}

std::vector<TickSample> ticks(SteadyTime begin, double seconds)
{
    std::vector<TickSample> ticks;
    for (int tick = 0; tick < static_cast<int>(seconds * 50.0); ++tick) {
        const SteadyTime time = begin + tick * std::chrono::milliseconds(20);
        const double since = Seconds(time.time_since_epoch()).count();
        const AxisPosition at = passAt(std::fmod(since, kPassLength));
        const AxisPosition before = passAt(std::fmod(since, kPassLength) - 0.1);
        ticks.push_back(
            {.time = time,
             .axes = {sampleOf(at.azimuth, since, (at.azimuth - before.azimuth).degrees() * 10.0),
                      sampleOf(at.elevation, since + 7.0, (at.elevation - before.elevation).degrees() * 10.0)}});
    }
    return ticks;
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
