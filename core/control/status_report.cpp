// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/status_report.h"

#include "core/base/text.h"
#include "core/control/permission_report.h"
#include "core/moteus/registers.h"

#include <algorithm>

namespace boresight {
namespace {

// Slower than this counts as standing: below the noise of the drive's velocity, far below any jog rate.
constexpr AngularRate kReportStanding = AngularRate::fromDegrees(0.02);
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

bool StatusReport::onTarget(Angle within) const
{
    const auto target = m_of.motion.target(m_of.now);
    const auto measured = m_of.drives.measured();
    return target && measured && near(*target, *measured, within);
}

bool StatusReport::arrived() const
{
    return m_of.motion.atRest() && onTarget(kArrived);
}

// The client's target itself, or what the operator's trim makes of it.
QString StatusReport::limitedReason() const
{
    return m_of.current.limitedReason().isEmpty() && m_of.motion.limited()
               ? Text::tr("the target is beyond %1").arg(toQString(m_of.motion.obstacle()))
               : m_of.current.limitedReason();
}

StationState StatusReport::state() const
{
    if (!m_of.arming.connected()) {
        return StationState::Disconnected;
    }
    if (m_of.arming.fault()) {
        return StationState::Fault;
    }
    if (m_of.arming.stopLatched()) {
        return StationState::Stopped;
    }
    switch (m_of.current.activity()) {
        case Activity::None:
            return StationState::Standby;
        case Activity::Holding:
            return StationState::Hold;
        case Activity::Pointing:
            return arrived() ? StationState::Hold : StationState::Slew;
        case Activity::Parking:
            return arrived() ? StationState::Parked : StationState::Slew;
        case Activity::Streaming:
            if (m_of.motion.streaming(m_of.now)) {
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

bool StatusReport::atTravelEnd(Axis axis) const
{
    if (!m_of.turns.known(axis)) {
        return false;
    }
    const TravelRange& travel = m_of.model.axis(axis).travel;
    const Angle place = m_of.motion.setpoint(axis).position;
    return place - travel.min < kAtTravelEnd || travel.max - place < kAtTravelEnd;
}

// Wants to go on and can not: the end of the travel, a limit, a keep-out, the horizon.
bool StatusReport::atLimit(Axis axis) const
{
    const bool pressed = !m_of.current.limitedReason().isEmpty() || m_of.current.runsFreely();
    return pressed &&
           (atTravelEnd(axis) || (m_of.facts.allKnown() && (m_of.motion.held(axis) || m_of.motion.limited(axis))));
}

AxisState StatusReport::axisState(Axis axis) const
{
    const Drive& drive = m_of.drives.drive(axis);
    const auto age = m_of.drives.age(axis, m_of.now);
    if (!age || *age > kNoData) {
        return AxisState::NoData;
    }
    if (drive.latched() && m_of.arming.fault()) {
        return AxisState::Fault;
    }
    if (!drive.answering(m_of.now)) {
        return AxisState::NoData;  // nobody knows what it does
    }
    if (drive.phase() == Drive::Phase::Held) {
        return AxisState::Holding;
    }
    if (drive.phase() != Drive::Phase::Engaged) {
        return ownState(axis);
    }
    if (abs(m_of.motion.setpoint(axis).rate) > kReportStanding) {
        return AxisState::Moving;
    }
    if (m_of.arming.stopLatched()) {
        return AxisState::Stopped;
    }
    return atLimit(axis) ? AxisState::Limit : AxisState::Holding;
}

// Of a drive that follows no set-points of ours.
AxisState StatusReport::ownState(Axis axis) const
{
    switch (m_of.drives.drive(axis).report()->mode) {
        case moteus::Mode::Stopped:
        case moteus::Mode::Fault:
            return AxisState::Off;
        case moteus::Mode::PositionTimeout:
            return m_of.facts.facts(axis) && m_of.facts.facts(axis)->holdsWhenNotFed ? AxisState::Holding
                                                                                     : AxisState::On;
        default:
            return AxisState::On;
    }
}

QString StatusReport::axisText(Axis axis, AxisState state) const
{
    if (state == AxisState::Limit) {
        const std::string what = m_of.motion.obstacle();
        return atTravelEnd(axis) || what.empty() ? Text::tr("at the end of the travel")
                                                 : Text::tr("at %1").arg(toQString(what));
    }
    if (!m_of.turns.known(axis)) {
        return Text::tr("turn not known");
    }
    const Drive& drive = m_of.drives.drive(axis);
    if ((state != AxisState::Holding && state != AxisState::On) || drive.phase() == Drive::Phase::Engaged) {
        return {};
    }
    if (drive.report()->mode != moteus::Mode::PositionTimeout) {
        return drive.activeUnordered() ? Text::tr("not by our orders") : QString();
    }
    return state == AxisState::Holding ? Text::tr("held by its own time-out mode")
                                       : Text::tr("in its own time-out mode");
}

AxisStatus StatusReport::axisStatus(Axis axis) const
{
    AxisStatus status{.state = axisState(axis),
                      .actual = m_of.drives.measured(axis),
                      .rate = m_of.drives.measuredRate(axis),
                      .age = m_of.drives.age(axis, m_of.now),
                      .travel = m_of.model.axis(axis).travel};
    if (m_of.drives.drive(axis).phase() == Drive::Phase::Engaged) {
        status.commanded = m_of.motion.setpoint(axis).position;
        status.commandedRate = m_of.motion.setpoint(axis).rate;
    }
    if (const auto target = m_of.motion.target(m_of.now)) {
        status.target = axis == Axis::Azimuth ? target->azimuth : target->elevation;
    }
    if (const auto& report = m_of.drives.drive(axis).report()) {
        fillTelemetry(status, *report);
        status.mode = static_cast<int>(report->mode);
        status.faultCode = report->fault;
    }
    status.stateText = axisText(axis, status.state);
    return status;
}

// One angle of a skewed model needs both of the axes.
void StatusReport::addBeam(StationStatus& status) const
{
    const pointing::PointingModel& model = m_of.model.pointing();
    const auto add = [&](std::optional<Angle> AxisStatus::*axis, std::optional<Angle> BeamAngles::*beam) {
        const std::optional<Angle>& azimuth = status.azimuth.*axis;
        const std::optional<Angle>& elevation = status.elevation.*axis;
        if (model.isIdentity()) {
            status.azimuth.beam.*beam = azimuth;
            status.elevation.beam.*beam = elevation;
        } else if (azimuth && elevation) {
            const SkyPointing direction = model.toSky({*azimuth, *elevation});
            status.azimuth.beam.*beam = direction.azimuth;
            status.elevation.beam.*beam = direction.elevation;
        }
    };
    add(&AxisStatus::actual, &BeamAngles::actual);
    add(&AxisStatus::commanded, &BeamAngles::commanded);
    add(&AxisStatus::target, &BeamAngles::target);
}

// Only an answer to this very tick counts: an older one would be drawn as if it were new.
AxisSample StatusReport::axisSample(Axis axis) const
{
    AxisSample sample;
    if (m_of.drives.drive(axis).phase() == Drive::Phase::Engaged) {
        sample.commanded = m_of.motion.setpoint(axis).position;
    }
    if (const auto& report = m_of.drives.drive(axis).report(); report && report->received >= m_of.now) {
        const auto& place = m_of.drives.drive(axis).place();
        sample.actual = place && place->received >= m_of.now ? m_of.drives.measured(axis) : std::nullopt;
        fillTelemetry(sample, *report);
    }
    return sample;
}

std::optional<TickSample> StatusReport::sample() const
{
    if (m_of.tick == 0) {
        return std::nullopt;
    }
    return TickSample{.time = m_of.now, .axes = {axisSample(Axis::Azimuth), axisSample(Axis::Elevation)}};
}

DriveStatus StatusReport::driveStatus(Axis axis) const
{
    return {.id = m_of.profile.axis(axis).id,
            .turnKnown = m_of.turns.known(axis),
            .turnQuestion =
                m_of.arming.drivesReadable() ? m_of.turns.question(axis, m_of.drives.drive(axis)) : std::nullopt,
            .crashStop = m_of.turns.memory().crashStops[index(axis)]};
}

// The survey's part is added by its owner.
DrivesStatus StatusReport::drivesStatus() const
{
    const auto isOn = [this](Axis axis) {
        const Drive& drive = m_of.drives.drive(axis);
        return drive.phase() != Drive::Phase::Listening ||
               (drive.report() && drive.report()->mode != moteus::Mode::Stopped);
    };
    return {.armingObstacle =
                m_of.arming.fitness() ? QString() : QString::fromStdString(m_of.arming.fitness().error().text),
            .released = m_of.arming.released(),
            .switchedOn = std::ranges::any_of(kAxes, isOn),
            .proofRunning = m_of.proof.running(),
            .proofText = m_of.proof.text(),
            .azimuth = driveStatus(Axis::Azimuth),
            .elevation = driveStatus(Axis::Elevation)};
}

StationStatus StatusReport::status() const
{
    StationStatus status{.state = state(),
                         .azimuth = axisStatus(Axis::Azimuth),
                         .elevation = axisStatus(Axis::Elevation),
                         .targetText = m_of.current.text(),
                         .commander = m_of.current.commander(),
                         .limited = !limitedReason().isEmpty(),
                         .limitedReason = limitedReason(),
                         .route = m_of.motion.route(),
                         .cableEnd = m_of.cable.end(),
                         .authority = m_of.arming.authority(),
                         .drives = drivesStatus(),
                         .alarms = m_of.alarms.list(),
                         .utc = m_of.clock.utc(),
                         .tick = m_of.tick};
    addBeam(status);
    status.stopLatched = m_of.arming.stopLatched();
    status.stateReason = m_of.arming.released()
                             ? Text::tr("the bus is left to other tools")
                             : m_of.arming.fault().value_or(m_of.cable.turnBackText().value_or(m_of.current.text()));
    if (const auto measured = m_of.drives.measured(); measured && m_of.facts.allKnown()) {
        status.actual = m_of.model.toSky(*measured);
    }
    if (m_of.drives.engaged() && m_of.facts.allKnown()) {
        status.commanded = m_of.model.toSky(m_of.motion.place());
    }
    if (const AxisPosition& trim = m_of.motion.trim(); trim != AxisPosition{}) {
        status.trim = SkyPointing{.azimuth = trim.azimuth, .elevation = trim.elevation};
    }
    status.permissions = PermissionReport(m_of).permissions();
    status.sunKeepOuts = m_of.sun.keepOuts();
    if (const auto& asked = m_of.current.limitedDirection()) {
        status.target = asked;
    } else if (const auto target = m_of.motion.target(m_of.now)) {
        status.target = m_of.model.toSky(*target);
    }
    return status;
}

}  // namespace boresight
