// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_status.h"

#include "core/alarms/catalogue.h"
#include "core/control/beam_report.h"
#include "tests/ui/sample_drives.h"
#include "tests/ui/sample_permissions.h"

#include <cmath>

namespace boresight::samples {

namespace {

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
    axis.turnKnown = true;
    return axis;
}

// Rises at 285°, culminates at 62° in the north, sets at 75°: the azimuth goes on through north to 435°.
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

void addAlarm(StationStatus& status, const AlarmKey& key, Severity severity, const QStringList& arguments)
{
    const AlarmText text = textOf(*key.entry, arguments);
    status.alarms.push_back({.id = status.alarms.size() + 1,
                             .name = QString::fromLatin1(key.entry->id),
                             .about = key.about,
                             .severity = severity,
                             .what = text.what,
                             .action = text.action,
                             .remedy = text.remedy,
                             .help = key.entry->help,
                             .since = kUtc - std::chrono::seconds(7)});
}

// One object for all statuses, as a station sends it.
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

void dropTarget(StationStatus& status)
{
    status.target.reset();
    status.azimuth.target.reset();
    status.elevation.target.reset();
    status.targetText.clear();
    status.errorBudget.reset();
}

// Of a client that sends fine points, on a mount with calibration points.
budget::ErrorBudget sampleBudget()
{
    using budget::ErrorPart;
    return {
        .lines = {{.part = ErrorPart::Servo,
                   .error = 0.031_deg,
                   .basis = QStringLiteral("Measured: rms of the last 10 s. Now 0.024°. Peak 0.052°.")},
                  {.part = ErrorPart::Way,
                   .error = 0.200_deg,
                   .basis = QStringLiteral("From the set-points to the target, now.")},
                  {.part = ErrorPart::Stream,
                   .error = 0.018_deg,
                   .basis = QStringLiteral("The points are 0.10° apart. The path foretold them with this rms error.")},
                  {.part = ErrorPart::Clock,
                   .basis = QStringLiteral("Boresight does not know the clock of the program that sends the points.")},
                  {.part = ErrorPart::Elements,
                   .basis = QStringLiteral("Boresight does not know the elements of the client.")},
                  {.part = ErrorPart::Calibration,
                   .error = 0.110_deg,
                   .basis = QStringLiteral(
                       "Residual rms of the measured points (6), at least the uncertainty of their centring.")},
                  {.part = ErrorPart::Wind,
                   .basis =
                       QStringLiteral("Not in the sum. Nothing measures how far the wind bends mast and antenna.")}},
        .sum = 0.231_deg,
        .isWhole = false,
        .loss = 0.0064};
}

StationStatus idle()
{
    StationStatus status;
    status.permissions = permitted();
    status.permissions.refuse(Action::FixDrives, QStringLiteral("every setting is right"));
    status.permissions.refuse(Action::Unwind,
                              QStringLiteral("The azimuth cable cannot be unwrapped further in this direction."));
    status.profile = sampleProfile();
    status.state = StationState::Parked;
    status.stateReason = QStringLiteral("park position reached");
    status.azimuth = axis(0_deg, {-90_deg, 450_deg});
    status.elevation = axis(0_deg, {0_deg, 90_deg});
    place(status, {}, {}, {});
    status.targetText = QStringLiteral("park");
    status.commander = {SourceKind::Operator, 0, QStringLiteral("operator")};
    status.line = {.state = MountLine::State::Up,
                   .kind = QStringLiteral("CAN"),
                   .name = QStringLiteral("simulated"),
                   .sent = 120'344,
                   .received = 120'344};
    status.simulated = true;
    status.listening = QStringLiteral("127.0.0.1:4533");
    status.utc = kUtc;
    status.drives.emplace();
    status.drives->driveCheck = DriveCheckState::Done;
    status.drives->switchedOn = true;
    status.drives->azimuth = drive(Axis::Azimuth);
    status.drives->elevation = drive(Axis::Elevation);
    return withClients(status, 1);
}

StationStatus tracking(double seconds)
{
    StationStatus status = idle();
    status.state = StationState::Track;
    status.stateReason = QStringLiteral("rotctld client sends targets");
    status.permissions = inMotion();
    place(status, passAt(seconds), passAt(seconds + 0.05), passAt(seconds + 0.6));
    status.azimuth.state = AxisState::Moving;
    status.elevation.state = AxisState::Moving;
    status.targetText = QStringLiteral("go to %1° %2°")
                            .arg(status.target->azimuth.degrees(), 0, 'f', 2)
                            .arg(status.target->elevation.degrees(), 0, 'f', 2);
    status.commander = {SourceKind::Client, 1, QStringLiteral("rotctld 127.0.0.1:51234")};
    status.clients.front().driving = true;
    status.errorBudget = sampleBudget();
    status.utc = kUtc + std::chrono::milliseconds(static_cast<int>(seconds * 1000.0));
    return status;
}

StationStatus stopped()
{
    StationStatus status = tracking(200.0);
    status.state = StationState::Stopped;
    status.stopLatched = true;
    status.stateReason = QStringLiteral("STOP pressed by operator");
    status.permissions = withoutMotion(QStringLiteral("STOP is latched. Reset STOP first."));
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
    status.permissions = withoutMotion(QStringLiteral("azimuth drive: over temperature. Re-arm first."));
    status.azimuth.state = AxisState::Fault;
    status.azimuth.stateText = QStringLiteral("over temperature (38)");
    status.drives->azimuth.registers = QStringLiteral("moteus mode 1, fault 38");
    status.elevation.state = AxisState::Holding;
    const QString drive = QStringLiteral("azimuth drive");
    addAlarm(
        status, alarmEntry("drive.fault").of(Axis::Azimuth), Severity::Alarm,
        {drive, QStringLiteral("38"), QStringLiteral("The board (75 °C by default) or the motor is too hot"),
         QStringLiteral("Likely cause: Too much torque for too long, or too little cooling. Let it cool down. Lower "
                        "the torque or improve the cooling. Then press Re-arm")});
    addAlarm(status, alarmEntry("drive.limit").of(Axis::Azimuth), Severity::Warning,
             {drive, QStringLiteral("100"), QStringLiteral("Current reduced because the board is warm"),
              QStringLiteral("Likely cause: Much torque for a long time, or too little cooling. The limit ends when "
                             "the board cools down. If the board gets hotter, fault 38 follows")});
    return status;
}

StationStatus disconnected()
{
    StationStatus status = withAge(tracking(150.0), std::chrono::milliseconds(3400));
    status.state = StationState::Disconnected;
    status.stateReason = QStringLiteral("no reply from azimuth and elevation");
    status.permissions = withoutMotion(QStringLiteral("no reply from the azimuth drive"));
    status.permissions.refuse(Action::SetAzimuth, QStringLiteral("no fresh position from the azimuth drive"));
    status.permissions.refuse(Action::SetElevation, QStringLiteral("no fresh position from the elevation drive"));
    for (const Action off : {Action::SwitchOff, Action::SwitchOffAzimuth, Action::SwitchOffElevation}) {
        status.permissions.refuse(off, QStringLiteral("every drive must answer"));
    }
    status.azimuth.state = AxisState::NoData;
    status.elevation.state = AxisState::NoData;
    status.line.state = MountLine::State::Lost;
    status.line.problem = QStringLiteral("can0 is gone: plug the adapter in again");
    status.simulated = false;
    for (const Axis axis : {Axis::Azimuth, Axis::Elevation}) {
        const QString drive =
            axis == Axis::Azimuth ? QStringLiteral("azimuth drive") : QStringLiteral("elevation drive");
        addAlarm(status, alarmEntry("drive.silent").of(axis), Severity::Alarm,
                 {drive, QStringLiteral("0.1"),
                  QStringLiteral("Check the supply, the CAN cable and the adapter. Then press Re-arm")});
    }
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
    status.permissions = inMotion();
    status.azimuth.state = AxisState::Moving;
    status.elevation.state = AxisState::Moving;
    place(status, {31_deg, 20_deg}, {33_deg, 22_deg}, {100_deg, 20_deg});
    status.route = beamPath({status.profile->azimuth.geometry, status.profile->elevation.geometry},
                            {{33_deg, 22_deg}, {62_deg, 48_deg}, {74_deg, 48_deg}, {100_deg, 20_deg}});
    status.targetText = QStringLiteral("go to 100.0° 20.0°");
    return status;
}

StationStatus cableEnding()
{
    StationStatus status = tracking(480.0);
    status.trim = SkyPointing{.azimuth = 0.3_deg, .elevation = -0.1_deg};
    status.cableEnd = CableEnd{.end = 450_deg, .in = Seconds(41.0), .turningBack = Seconds(37.0)};
    addAlarm(status, alarmEntry("cable.turns-back"), Severity::Warning,
             {QStringLiteral("450.0°"), QStringLiteral("17:14:40Z"), QStringLiteral("37 s")});
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
    for (const Action action : {Action::JogRight, Action::StepRight}) {
        status.permissions.refuse(action, QStringLiteral("at the upper limit 150.0°"));
    }
    for (const Action action : {Action::JogDown, Action::StepDown}) {
        status.permissions.refuse(action, QStringLiteral("at the lower limit 10.0°"));
    }
    status.targetText = QStringLiteral("go to 171.25° -2.40°");
    status.limited = true;
    status.limitedReason = QStringLiteral("elevation -2.4° below limit 10.0°");
    addAlarm(status, alarmEntry("target.outside"), Severity::Advisory, {status.limitedReason});
    return status;
}

StationStatus operatorMoving()
{
    StationStatus status = tracking(20.0);
    status.state = StationState::Slew;
    status.stateReason = QStringLiteral("go to 113.0° 10.0°");
    status.slew = SlewProgress{.remaining = Seconds(6.0), .done = 0.3};
    place(status, {62_deg, 24_deg}, {64.5_deg, 23_deg}, {113_deg, 10_deg});
    status.targetText = QStringLiteral("go to 113.0° 10.0°");
    status.commander = {SourceKind::Operator, 0, QStringLiteral("operator")};
    status.authority = Authority::Operator;
    return status;
}

StationStatus freshMount()
{
    StationStatus status = idle();
    profile::Profile fresh = *status.profile;
    fresh.mount.directions = profile::Directions::Unconfirmed;
    status.profile = std::make_shared<const profile::Profile>(fresh);
    status.permissions = withoutPointing(
        QStringLiteral("The directions of the axes are not confirmed. Jog each axis a little and confirm them first."));
    status.permissions.fastestJog = profile::kFastestUnconfirmed;
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
        .inControl = true,
        .advice = QStringLiteral("This Gpredict updates only every 10°. Set Threshold to 0.1 in its Antenna Control."),
        .controlObstacle = QStringLiteral("this client has control")};
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
    update.status = judged(status);
    return update;
}

StationUpdate refusal(const StationStatus& status, std::uint64_t requestId, const char* reason)
{
    StationUpdate refused = update(status);
    refused.answers.push_back({requestId, Error{ErrorCode::Refused, QString::fromUtf8(reason)}});
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
