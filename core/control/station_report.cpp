// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl that tells the world what it knows.
#include "core/base/text.h"
#include "core/control/station_control.h"
#include "core/moteus/registers.h"

#include <algorithm>

namespace boresight {
namespace {

// Slower than this counts as standing: below the noise of the drive's velocity, far below any jog rate.
constexpr AngularRate kReportStanding = AngularRate::fromDegrees(0.02);
constexpr Angle kAtTravelEnd = Angle::fromDegrees(0.05);
// A target within this of the measured direction counts as tracked, not as slewed to.
constexpr Angle kOnTarget = Angle::fromDegrees(1.0);
// A place is reached when the set-points rest there and the antenna is this near.
constexpr Angle kArrived = Angle::fromDegrees(0.3);
constexpr std::chrono::seconds kNoData{2};

bool near(const AxisPosition& a, const AxisPosition& b, Angle distance)
{
    return abs(a.azimuth - b.azimuth) < distance && abs(a.elevation - b.elevation) < distance;
}

// What an AxisStatus and an AxisSample say alike of the drive itself.
void fillTelemetry(auto& values, const DriveReport& report)
{
    values.busVoltage = report.voltage;
    values.boardTemperature = report.boardTemperature;
    values.torque = report.torque;
    values.current = report.current;
    values.motorTemperature = report.motorTemperature;
}

}  // namespace

bool StationControl::onTarget(Angle within) const
{
    const auto target = m_motion.target(m_now);
    const auto measured = m_drives.measured();
    return target && measured && near(*target, *measured, within);
}

bool StationControl::arrived() const
{
    return m_motion.atRest() && onTarget(kArrived);
}

StationState StationControl::state() const
{
    if (!m_arming.connected()) {
        return StationState::Disconnected;
    }
    if (m_arming.fault()) {
        return StationState::Fault;
    }
    if (m_arming.stopLatched()) {
        return StationState::Stopped;
    }
    switch (m_current.activity()) {
        case Activity::None:
            return StationState::Standby;
        case Activity::Holding:
            return StationState::Hold;
        case Activity::Pointing:
            return arrived() ? StationState::Hold : StationState::Slew;
        case Activity::Parking:
            return arrived() ? StationState::Parked : StationState::Slew;
        case Activity::Streaming:
            if (m_motion.streaming(m_now)) {
                return onTarget(kOnTarget) ? StationState::Track : StationState::Slew;
            }
            return arrived() ? StationState::Hold : StationState::Slew;
        case Activity::Jogging:
        case Activity::Running:
            return StationState::Jog;
        case Activity::Proving:
            return StationState::Calibrate;
    }
    return StationState::Fault;
}

bool StationControl::atTravelEnd(Axis axis) const
{
    if (!m_turns.known(axis)) {
        return false;
    }
    const TravelRange& travel = m_model.axis(axis).travel;
    const Angle place = m_motion.setpoint(axis).position;
    return place - travel.min < kAtTravelEnd || travel.max - place < kAtTravelEnd;
}

// Wants to go on and can not: the end of the travel, a limit, a keep-out, the horizon.
bool StationControl::atLimit(Axis axis) const
{
    const bool pressed = !m_current.limitedReason().isEmpty() || m_current.runsFreely();
    return pressed && (atTravelEnd(axis) || (turnsKnown() && (m_motion.held(axis) || m_motion.limited(axis))));
}

AxisState StationControl::axisState(Axis axis) const
{
    const Drive& drive = m_drives.drive(axis);
    const auto age = m_drives.age(axis, m_now);
    if (!age || *age > kNoData) {
        return AxisState::NoData;
    }
    if (drive.latched() && m_arming.fault()) {
        return AxisState::Fault;
    }
    if (!drive.answering(m_now)) {
        return AxisState::NoData;  // nobody knows what it does
    }
    if (drive.phase() == Drive::Phase::Held) {
        return AxisState::Holding;
    }
    if (drive.phase() != Drive::Phase::Engaged) {
        return ownState(axis);
    }
    if (abs(m_motion.setpoint(axis).rate) > kReportStanding) {
        return AxisState::Moving;
    }
    if (m_arming.stopLatched()) {
        return AxisState::Stopped;
    }
    return atLimit(axis) ? AxisState::Limit : AxisState::Holding;
}

// Of a drive that follows no set-points of ours.
AxisState StationControl::ownState(Axis axis) const
{
    switch (m_drives.drive(axis).report()->mode) {
        case moteus::Mode::Stopped:
        case moteus::Mode::Fault:
            return AxisState::Off;
        case moteus::Mode::PositionTimeout:
            return facts(axis) && facts(axis)->holdsWhenNotFed ? AxisState::Holding : AxisState::On;
        default:
            return AxisState::On;
    }
}

QString StationControl::axisText(Axis axis, AxisState state) const
{
    if (state == AxisState::Limit) {
        const std::string what = m_motion.obstacle();
        return atTravelEnd(axis) || what.empty() ? Text::tr("at the end of the travel")
                                                 : Text::tr("at %1").arg(toQString(what));
    }
    if (!m_turns.known(axis)) {
        return Text::tr("turn not known");
    }
    const Drive& drive = m_drives.drive(axis);
    if ((state != AxisState::Holding && state != AxisState::On) || drive.phase() == Drive::Phase::Engaged) {
        return {};
    }
    if (drive.report()->mode != moteus::Mode::PositionTimeout) {
        return drive.activeUnordered() ? Text::tr("not by our orders") : QString();
    }
    return state == AxisState::Holding ? Text::tr("held by its own time-out mode")
                                       : Text::tr("in its own time-out mode");
}

AxisStatus StationControl::axisStatus(Axis axis) const
{
    AxisStatus status{.state = axisState(axis),
                      .actual = m_drives.measured(axis),
                      .rate = m_drives.measuredRate(axis),
                      .age = m_drives.age(axis, m_now),
                      .travel = m_model.axis(axis).travel};
    if (m_drives.drive(axis).phase() == Drive::Phase::Engaged) {
        status.commanded = m_motion.setpoint(axis).position;
        status.commandedRate = m_motion.setpoint(axis).rate;
    }
    if (const auto target = m_motion.target(m_now)) {
        status.target = axis == Axis::Azimuth ? target->azimuth : target->elevation;
    }
    if (const auto& report = m_drives.drive(axis).report()) {
        fillTelemetry(status, *report);
        status.mode = static_cast<int>(report->mode);
        status.faultCode = report->fault;
    }
    status.stateText = axisText(axis, status.state);
    return status;
}

// Only an answer to this very tick counts: an older one would be drawn as if it were new.
AxisSample StationControl::axisSample(Axis axis) const
{
    AxisSample sample;
    if (m_drives.drive(axis).phase() == Drive::Phase::Engaged) {
        sample.commanded = m_motion.setpoint(axis).position;
    }
    if (const auto& report = m_drives.drive(axis).report(); report && report->received >= m_now) {
        const auto& place = m_drives.drive(axis).place();
        sample.actual = place && place->received >= m_now ? m_drives.measured(axis) : std::nullopt;
        fillTelemetry(sample, *report);
    }
    return sample;
}

std::optional<TickSample> StationControl::sample() const
{
    if (m_tick == 0) {
        return std::nullopt;
    }
    return TickSample{.time = m_now, .axes = {axisSample(Axis::Azimuth), axisSample(Axis::Elevation)}};
}

bool StationControl::turnsReadable() const
{
    return m_arming.fitness() || m_arming.fitness().error().code == ErrorCode::Busy;
}

std::optional<memory::TurnQuestion> StationControl::turnQuestion(Axis axis) const
{
    return turnsReadable() ? m_turns.question(axis, m_drives.drive(axis)) : std::nullopt;
}

DriveStatus StationControl::driveStatus(Axis axis) const
{
    return {.id = m_profile.axis(axis).id,
            .turnKnown = m_turns.known(axis),
            .turnQuestion = turnQuestion(axis),
            .crashStop = m_turns.memory().crashStops[index(axis)]};
}

// The survey's part is added by its owner.
DrivesStatus StationControl::drivesStatus() const
{
    const auto isOn = [this](Axis axis) {
        const Drive& drive = m_drives.drive(axis);
        return drive.phase() != Drive::Phase::Listening ||
               (drive.report() && drive.report()->mode != moteus::Mode::Stopped);
    };
    return {.armingObstacle = m_arming.fitness() ? QString() : QString::fromStdString(m_arming.fitness().error().text),
            .released = m_arming.released(),
            .switchedOn = std::ranges::any_of(kAxes, isOn),
            .proofRunning = m_proof.running(),
            .proofText = m_proof.text(),
            .azimuth = driveStatus(Axis::Azimuth),
            .elevation = driveStatus(Axis::Elevation)};
}

StationStatus StationControl::status() const
{
    StationStatus status{.state = state(),
                         .azimuth = axisStatus(Axis::Azimuth),
                         .elevation = axisStatus(Axis::Elevation),
                         .targetText = m_current.text(),
                         .commander = m_current.commander(),
                         .limited = !limitedReason().isEmpty(),
                         .limitedReason = limitedReason(),
                         .route = m_motion.route(),
                         .cableEnd = m_cable.end(),
                         .authority = m_arming.authority(),
                         .drives = drivesStatus(),
                         .alarms = m_alarms.list(),
                         .utc = m_clock.utc(),
                         .tick = m_tick};
    status.stopLatched = m_arming.stopLatched();
    status.stateReason = m_arming.released()
                             ? Text::tr("the bus is left to other tools")
                             : m_arming.fault().value_or(m_cable.turnBackText().value_or(m_current.text()));
    if (const auto measured = m_drives.measured(); measured && turnsKnown()) {
        status.actual = m_model.toSky(*measured);
    }
    if (m_drives.engaged() && turnsKnown()) {
        status.commanded = m_model.toSky(m_motion.place());
    }
    if (const AxisPosition& trim = m_motion.trim(); trim != AxisPosition{}) {
        status.trim = SkyPointing{.azimuth = trim.azimuth, .elevation = trim.elevation};
    }
    status.sunKeepOuts = m_sun.keepOuts();
    if (const auto& asked = m_current.limitedDirection()) {
        status.target = asked;
    } else if (const auto target = m_motion.target(m_now)) {
        status.target = m_model.toSky(*target);
    }
    return status;
}

}  // namespace boresight
