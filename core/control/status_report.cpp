// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/status_report.h"

#include "core/base/text.h"
#include "core/control/beam_report.h"
#include "core/control/calibration_source.h"
#include "core/control/permission_report.h"
#include "core/messages/no_data.h"
#include "core/mount/mount_service.h"

#include <algorithm>

namespace boresight {
namespace {

// An axis whose set-point is slower than this counts as standing. The value is far below every jog rate.
constexpr AngularRate kReportStanding = AngularRate::fromDegrees(0.02);
// A place is reached when the set-points stand there and the axes are this near.
constexpr Angle kArrived = Angle::fromDegrees(0.3);

// Allows for rounding when a target lies exactly between two places that the rotator can reach.
constexpr Angle kBetweenSteps = Angle::fromDegrees(0.001);

// The values of the drive that AxisStatus and AxisSample have in common.
void fillTelemetry(auto& values, const AxisReport& report)
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
    const auto measured = m_of.mount.measured();
    if (!target || !measured) {
        return false;
    }
    const Capabilities can = m_of.mount.capabilities();
    const auto near = [&](Axis axis, Angle away) {
        const Angle inexactness = can.inexactness(axis) + m_of.motion.band(axis, m_of.now);
        return abs(away) < std::max(within, inexactness + kBetweenSteps);
    };
    return near(Axis::Azimuth, target->azimuth - measured->azimuth) &&
           near(Axis::Elevation, target->elevation - measured->elevation);
}

bool StatusReport::arrived() const
{
    return m_of.motion.atRest() && onTarget(kArrived);
}

// Either the target itself is not permitted, or the sum of the target and the operator's trim is not.
QString StatusReport::limitedReason() const
{
    return m_of.current.limitedReason().isEmpty() && m_of.motion.limited()
               ? Text::tr("the target is beyond %1").arg(m_of.motion.obstacle())
               : m_of.current.limitedReason();
}

bool StatusReport::aimed() const
{
    const bool isAimed = m_of.current.is(Activity::Pointing) || m_of.current.is(Activity::Streaming);
    return isAimed && !m_of.current.isFor(calibrationSource());
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
        case Activity::Placing:
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
        case Activity::Trying:
        case Activity::Proving:
            return StationState::Calibrate;
    }
    return StationState::Fault;
}

bool StatusReport::atTravelEnd(Axis axis) const
{
    if (!m_of.mount.report(axis).wrapKnown) {
        return false;
    }
    const TravelRange& travel = m_of.motion.travel(axis);
    const Angle place = m_of.motion.setpoint(axis).position;
    return place - travel.min < kAtEdge || travel.max - place < kAtEdge;
}

// Whether the end of the travel, a limit, a keep-out or the horizon stops a motion that would go on.
bool StatusReport::atLimit(Axis axis) const
{
    const bool pressed = !m_of.current.limitedReason().isEmpty() || m_of.current.runsFreely();
    return pressed &&
           (atTravelEnd(axis) || (m_of.mount.wrapsKnown() && (m_of.motion.held(axis) || m_of.motion.limited(axis))));
}

// The age of the place. While there is no place, the age of the last reply.
std::optional<std::chrono::milliseconds> StatusReport::age(const AxisReport& report) const
{
    if (!report.heard) {
        return std::nullopt;
    }
    return std::chrono::duration_cast<std::chrono::milliseconds>(m_of.now -
                                                                 (report.place ? report.placed : *report.heard));
}

AxisState StatusReport::axisState(Axis axis, const AxisReport& report) const
{
    if (!m_of.mount.capabilities().has(axis)) {
        return AxisState::Missing;
    }
    const auto old = age(report);
    if (!old || *old >= kNoDataAfter) {
        return AxisState::NoData;
    }
    if (report.latched && m_of.arming.fault()) {
        return AxisState::Fault;
    }
    if (!report.answers) {
        return AxisState::NoData;  // the drive does not answer, so its state is unknown
    }
    switch (report.hand) {
        case AxisHand::Off:
            return AxisState::Off;
        case AxisHand::On:
        case AxisHand::Unordered:
        case AxisHand::TimedOut:
            return AxisState::On;
        case AxisHand::HoldsItself:
        case AxisHand::Held:
            return AxisState::Holding;
        case AxisHand::Follows:
            break;
    }
    if (abs(m_of.motion.setpoint(axis).rate) > kReportStanding) {
        return AxisState::Moving;
    }
    if (m_of.arming.stopLatched()) {
        return AxisState::Stopped;
    }
    return atLimit(axis) ? AxisState::Limit : AxisState::Holding;
}

QString StatusReport::axisText(Axis axis, AxisState state, const AxisReport& report) const
{
    if (state == AxisState::Limit) {
        const QString what = m_of.motion.obstacle();
        return atTravelEnd(axis) || what.isEmpty() ? Text::tr("at the end of the travel") : Text::tr("at %1").arg(what);
    }
    if (!report.wrapKnown && report.place) {
        return Text::tr("wrap unknown");
    }
    if (state != AxisState::Holding && state != AxisState::On) {
        return {};
    }
    switch (report.hand) {
        case AxisHand::Unordered:
            return Text::tr("not commanded by Boresight");
        case AxisHand::HoldsItself:
            return Text::tr("holds by itself");
        case AxisHand::TimedOut:
            return Text::tr("in its own time-out mode");
        default:
            return {};
    }
}

AxisStatus StatusReport::axisStatus(Axis axis) const
{
    const AxisReport report = m_of.mount.report(axis);
    AxisStatus status{.state = axisState(axis, report),
                      .actual = report.place,
                      .rate = report.rate,
                      .age = age(report),
                      .travel = m_of.model.axis(axis).travel};
    if (report.hand == AxisHand::Follows) {
        status.commanded = m_of.motion.setpoint(axis).position;
        status.commandedRate = m_of.motion.setpoint(axis).rate;
    }
    if (const auto target = m_of.motion.target(m_of.now)) {
        status.target = axis == Axis::Azimuth ? target->azimuth : target->elevation;
    }
    fillTelemetry(status, report);
    status.power = report.power;
    status.turnKnown = report.wrapKnown;
    status.stateText = axisText(axis, status.state, report);
    return status;
}

// The rest of the way, from the set-points on.
std::vector<SkyPointing> StatusReport::route() const
{
    std::vector<AxisPosition> way = m_of.slew.way(m_of.now);
    if (way.empty() || !m_of.mount.follows() || !m_of.mount.wrapsKnown()) {
        return {};
    }
    way.insert(way.begin(), m_of.motion.place());
    return beamPath(m_of.model, way);
}

// Only a reply to this tick counts. A chart would draw an older reply as if it were new.
AxisSample StatusReport::axisSample(Axis axis) const
{
    const AxisReport report = m_of.mount.report(axis);
    AxisSample sample;
    if (report.hand == AxisHand::Follows) {
        sample.commanded = m_of.motion.setpoint(axis).position;
    }
    if (report.heard && *report.heard >= m_of.now) {
        sample.actual = report.placed >= m_of.now ? report.place : std::nullopt;
        fillTelemetry(sample, report);
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

std::optional<DrivesStatus> StatusReport::drivesStatus() const
{
    const MountService* const service = m_of.mount.service();
    if (service == nullptr) {
        return std::nullopt;
    }
    DrivesStatus status;
    const Result<>& interlock = m_of.mount.interlock();
    status.armingObstacle = interlock ? QString() : interlock.error().text;
    service->describe(status);
    return status;
}

StationStatus StatusReport::status() const
{
    StationStatus status = brief();
    status.route = route();
    status.permissions = PermissionReport(m_of).permissions();
    return status;
}

StationStatus StatusReport::brief() const
{
    const QString limited = limitedReason();
    StationStatus status{
        .state = state(),
        .azimuth = axisStatus(Axis::Azimuth),
        .elevation = axisStatus(Axis::Elevation),
        .targetText = m_of.current.text(),
        .commander = m_of.current.commander(),
        .aimed = aimed(),
        .limited = !limited.isEmpty(),
        .limitedReason = limited,
        .slew = m_of.slew.progress(m_of.now),
        .cableEnd = m_of.cable.end(),
        .authority = m_of.arming.authority(),
        .tookControl = m_of.arming.tookByAct() && m_of.clientControl.isWanted(m_of.profile.rotctld, m_of.now),
        .antenna = m_of.antenna.inUse().name,
        .chosenAntenna = m_of.antenna.chosen().name,
        .drives = drivesStatus(),
        .alarms = m_of.alarms.list(),
        .utc = m_of.clock.utc(),
        .tick = m_of.tick};
    status.power = m_of.energy.status();
    addBeam(status, m_of.model.pointing());
    status.stopLatched = m_of.arming.stopLatched();
    status.stateReason = !m_of.mount.available()
                             ? Text::tr("the bus is released to other tools")
                             : m_of.arming.fault().value_or(m_of.cable.turnBackText().value_or(m_of.current.text()));
    if (const auto measured = m_of.mount.measured(); measured && m_of.mount.wrapsKnown()) {
        status.actual = m_of.model.toSky(*measured);
    }
    if (m_of.mount.follows() && m_of.mount.wrapsKnown()) {
        status.commanded = m_of.model.toSky(m_of.motion.place());
    }
    if (const AxisPosition& trim = m_of.motion.trim(); trim != AxisPosition{}) {
        status.trim = SkyPointing{.azimuth = trim.azimuth, .elevation = trim.elevation};
    }
    status.capabilities = m_of.mount.capabilities();
    status.sunKeepOuts = m_of.sun.keepOuts();
    if (const auto& asked = m_of.current.limitedDirection()) {
        status.target = asked;
    } else if (const auto target = m_of.motion.target(m_of.now)) {
        status.target = m_of.model.toSky(*target);
    }
    return status;
}

}  // namespace boresight
