// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/control/walk/station_promises.h"

#include "core/base/overloaded.h"
#include "core/tracking/emergency_braking.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight {
namespace {

using moteus::Register;

// A stop from full speed takes 1 s, the averaging takes 0.2 s, and a second drive is captured before it brakes.
constexpr int kStopTicks = 90;
// The first steps of a motion can be too small to show in a float of the frame.
constexpr int kUnseenTicks = 3;
// An axis that reverses its direction stands still for a moment, at most for the averaging time of 0.2 s.
constexpr int kTurningTicks = 10;
constexpr double kStill = 1e-9;     // turns between two set-points
constexpr double kAtBorder = 0.05;  // degrees
constexpr Angle kSamePlace = Angle::fromDegrees(1e-3);
constexpr double kLongestStep = 0.1;  // seconds: a longer step only slows the mount, it must not jump
// A drive that slipped while it received nothing catches up at most this long afterwards, which is as long as it may be
// silent.
constexpr int kSlipTicks = 15;
constexpr double kPlaceNoise = 0.3;  // degrees: a smaller error of a reply is believed
// A drive that has no known place can be captured on false replies that agree. Then it is sent to the false place. A
// real drive goes there within the limits of its frames, an ideal drive at once.
constexpr int kCaptureTicks = 3;
// Number of ticks for which a drive may still be commanded to ignore its bounds after the axis has come back inside
// them.
constexpr int kBoundsTicks = 6;

const AxisStatus& axisOf(const StationStatus& status, Axis axis)
{
    return axis == Axis::Azimuth ? status.azimuth : status.elevation;
}

bool knows(const StationStatus& status, Axis axis)
{
    return axis == Axis::Azimuth ? status.azimuth.turnKnown : status.elevation.turnKnown;
}

bool knowsBoth(const StationStatus& status)
{
    return knows(status, Axis::Azimuth) && knows(status, Axis::Elevation);
}

std::optional<AxisRates> ratesOf(const Request& request)
{
    if (const auto* const jog = std::get_if<request::Jog>(&request)) {
        return jog->rates;
    }
    if (const auto* const move = std::get_if<request::Move>(&request)) {
        return move->rates;
    }
    return std::nullopt;
}

bool endsMotion(const Request& request)
{
    using namespace request;
    return std::holds_alternative<Hold>(request) || std::holds_alternative<Stop>(request) ||
           std::holds_alternative<SwitchOff>(request) || std::holds_alternative<ReleaseBus>(request) ||
           std::holds_alternative<EndProof>(request);
}

bool asksForMotion(const Request& request)
{
    using namespace request;
    const auto rates = ratesOf(request);
    return (rates && *rates != AxisRates{}) || std::holds_alternative<PointSky>(request) ||
           std::holds_alternative<PointAxes>(request) || std::holds_alternative<Move>(request) ||
           std::holds_alternative<Step>(request) || std::holds_alternative<Park>(request) ||
           std::holds_alternative<Home>(request) || std::holds_alternative<Unwind>(request) ||
           std::holds_alternative<ProveCrashStop>(request);
}

}  // namespace

void StationPromises::fail(const std::string& what)
{
    if (m_broken.empty()) {
        m_broken = what;
    }
}

void StationPromises::asked(const Request& request, const Source& source, bool accepted, const StationStatus& before)
{
    if (std::holds_alternative<request::Stop>(request)) {
        m_stopped = true;
        if (!accepted) {
            fail("STOP was refused");
        }
    }
    if (!accepted) {
        return;
    }
    watchControl(request, source);
    if (std::holds_alternative<request::ResetStop>(request)) {
        m_stopped = false;
    } else if (std::holds_alternative<request::Rearm>(request)) {
        m_rearmed = true;
    } else if (endsMotion(request)) {
        end();
    } else if (asksForMotion(request)) {
        askedForMotion(request, source, before);
    } else if (std::holds_alternative<request::Jog>(request) && m_permit && m_permit->jog &&
               m_permit->source == source) {
        end();  // zero rates
    } else if (std::holds_alternative<request::TakeAuthority>(request) && m_permit &&
               m_permit->source.kind == SourceKind::Client) {
        end();
    }
}

// Only one client moves the mount, and no client that is read-only.
void StationPromises::watchControl(const Request& request, const Source& source)
{
    if (const auto* const given = std::get_if<request::GiveControl>(&request)) {
        m_readOnly.at(given->clientId) = false;
        m_lead =
            Permit{.source = {.kind = SourceKind::Client, .clientId = given->clientId}, .given = m_rig.clock.now()};
    } else if (const auto* const set = std::get_if<request::SetReadOnly>(&request)) {
        m_readOnly.at(set->clientId) = set->readOnly;
        if (set->readOnly && m_lead && m_lead->source.clientId == set->clientId) {
            m_lead.reset();
        }
    } else if (source.kind == SourceKind::Client && asksForMotion(request)) {
        const bool led = m_lead && m_lead->source.clientId != source.clientId &&
                         m_rig.clock.now() - m_lead->given < ClientControl::kRelease;
        if ((led && m_rig.profile.rotctld.control == profile::ControlRule::First) || m_readOnly.at(source.clientId)) {
            fail("a client's motion was accepted though another leads or it is read-only");
        }
        m_lead = Permit{.source = source, .given = m_rig.clock.now()};
    }
    const bool ended = m_permit && m_permit->source.kind == SourceKind::Client &&
                       ((std::holds_alternative<request::GiveControl>(request) &&
                         m_permit->source.clientId != m_lead->source.clientId) ||
                        m_readOnly.at(m_permit->source.clientId));
    if (ended) {
        end();
    }
}

void StationPromises::askedForMotion(const Request& request, const Source& source, const StationStatus& before)
{
    const auto rates = ratesOf(request);
    const AngularRate unwind = m_rig.profile.jog.unwind;
    const bool slow =
        rates && source.kind == SourceKind::Operator && std::max(abs(rates->azimuth), abs(rates->elevation)) <= unwind;
    if (m_stopped || m_faulty || !m_fit || before.drives->released || before.drives->proofRunning) {
        fail("a motion was accepted though stopped, faulty, unfit, released or in a proof");
    }
    if (source.kind == SourceKind::Client && before.authority == Authority::Operator) {
        fail("a client's motion was accepted though the operator has the authority");
    }
    if (!knowsBoth(before) && !slow) {
        fail("a motion was accepted though a turn is not known");
    }
    m_permit = {.source = source,
                .jog = std::holds_alternative<request::Jog>(request),
                .run = std::holds_alternative<request::Move>(request),
                .slow = slow,
                .given = m_rig.clock.now()};
}

void StationPromises::sourceGone(const Source& source)
{
    if (m_permit && m_permit->run && m_permit->source == source) {
        end();
    }
    if (source.kind == SourceKind::Client) {
        m_readOnly.at(source.clientId) = false;
    }
    if (m_lead && m_lead->source.clientId == source.clientId) {
        m_lead.reset();
    }
}

void StationPromises::ticked(Seconds step)
{
    StationStatus now = m_rig.control.briefStatus();
    watchLatches(now);
    watchEnds(now);
    watchFrames(now);
    watchRegion(now);
    watchBrake(now);
    for (const Axis axis : kAxes) {
        watchPath(axis, now, step);
        watchAxis(axis, now, step);
    }
    m_before = std::move(now);
}

void StationPromises::watchLatches(const StationStatus& now)
{
    const bool latched = m_rig.control.faultLatched();
    if (latched && !m_faulty) {
        m_rearmed = false;
        ++m_losses;
    }
    const bool byPolicy = m_rig.profile.recovery != profile::RecoverySettings{};
    if (m_faulty && !latched && !m_rearmed && !byPolicy) {
        fail("a fault went away without a re-arm");
    }
    m_faulty = latched;
    if (now.stopLatched != m_stopped) {
        fail("STOP does not stay as it was asked for");
    }
    for (const Axis axis : kAxes) {
        const fakes::IdealDrive& drive = axis == Axis::Azimuth ? m_rig.azimuth : m_rig.elevation;
        int& faulty = m_traces[index(axis)].faultyTicks;
        faulty = drive.mode == moteus::Mode::Fault && !drive.silent && !now.drives->released ? faulty + 1 : 0;
        if (faulty > 3 && !latched) {
            fail("a drive in fault was not noticed");
        }
    }
}

void StationPromises::watchEnds(const StationStatus& now)
{
    const bool lapsed = m_permit && m_permit->jog && m_rig.clock.now() - m_permit->given > kJogKeepAlive;
    if (m_stopped || m_faulty || !m_fit || lapsed || now.drives->released || now.state == StationState::Disconnected) {
        end();
    }
    m_sinceEnd = m_permit ? 0 : m_sinceEnd + 1;
    m_sinceUnknown = knowsBoth(now) ? 0 : m_sinceUnknown + 1;
}

void StationPromises::watchFrames(const StationStatus& now)
{
    for (const Axis axis : kAxes) {
        const fakes::IdealDrive& drive = axis == Axis::Azimuth ? m_rig.azimuth : m_rig.elevation;
        if (drive.seen.empty()) {
            m_traces[index(axis)].position.reset();  // the drive received nothing and may go on with its last command
        }
        for (const auto& seen : drive.seen) {
            watchFrame(axis, seen, now);
        }
    }
}

void StationPromises::watchFrame(Axis axis, const fakes::IdealDrive::Seen& seen, const StationStatus& now)
{
    const auto field = [&](Register reg) { return seen.fields.find(reg).value_or(std::nan("")); };
    if (seen.mode != moteus::Mode::Position) {
        m_traces[index(axis)].position.reset();
        m_traces[index(axis)].still = AxisTrace{}.still;
        if (seen.mode != moteus::Mode::Stopped) {
            fail("a mode that nobody asked for");
        }
        return;
    }
    const double watchdog = field(Register::CommandWatchdogTimeout);
    if (!(watchdog > 0.0 && watchdog <= m_rig.profile.control.watchdog.count() + 1e-6) ||
        !(field(Register::CommandMaximumTorque) > 0.0) || !(field(Register::CommandVelocityLimit) > 0.0) ||
        !(field(Register::CommandAccelerationLimit) > 0.0)) {
        fail("a position frame without watchdog or limits");
    }
    watchBounds(axis, seen, now);
    watchSetpoint(axis, field(Register::CommandPosition), field(Register::CommandVelocity), now);
}

// A set-point that moves: a velocity without a position, or a position that changes.
void StationPromises::watchSetpoint(Axis axis, double position, double velocity, const StationStatus& now)
{
    AxisTrace& trace = m_traces[index(axis)];
    const bool runs = !std::isfinite(position) && velocity != 0.0;
    if (!std::isfinite(position) && !runs) {  // "hold where you are"
        trace.position.reset();
        trace.still = AxisTrace{}.still;
        trace.sinceHold = 0;
        return;
    }
    ++trace.sinceHold;
    const bool moves =
        runs || (trace.position && std::abs(position - *trace.position) > kStill && !takesOver(axis, now));
    if (moves && trace.still > kTurningTicks) {
        ++m_motions;
        if (!m_permit && m_sinceEnd > kUnseenTicks) {
            fail("a motion began that nobody asked for");
        }
        if (!m_isBrakeOpen) {
            fail("a motion began before the brake was open");
        }
    }
    if (moves && m_sinceEnd > kStopTicks) {
        fail("an axis still moves though its motion was ended");
    }
    if (moves && m_sinceUnknown > kStopTicks && !(m_permit && m_permit->slow) && m_sinceEnd > kStopTicks) {
        fail("an axis moves though its turn is not known");
    }
    if (moves && m_sinceUnknown > kStopTicks && m_sinceEnd == 0 && !m_permit->slow) {
        fail("an axis moves fast though its turn is not known");
    }
    trace.position = runs ? std::nullopt : std::optional(position);
    trace.still = moves ? 0 : trace.still + 1;
}

// After a loss a set-point that stands still starts again at the measured position. That is no motion.
bool StationPromises::takesOver(Axis axis, const StationStatus& now) const
{
    const AxisStatus& is = axisOf(now, axis);
    const AxisStatus& was = axisOf(m_before, axis);
    return m_faulty && is.commanded && was.actual && *is.commandedRate == AngularRate{} &&
           abs(*is.commanded - *was.actual) < kSamePlace;
}

void StationPromises::watchBounds(Axis axis, const fakes::IdealDrive::Seen& seen, const StationStatus& now)
{
    const bool ignored = seen.fields.find(Register::CommandIgnorePositionBounds).value_or(0.0) != 0.0;
    const auto inside = [&](const StationStatus& status) {
        const AxisStatus& of = axisOf(status, axis);
        return knows(status, axis) && of.actual && of.actual->degrees() > of.travel.min.degrees() + kAtBorder &&
               of.actual->degrees() < of.travel.max.degrees() - kAtBorder;
    };
    if (ignored && ((inside(now) && inside(m_before)) || m_traces[index(axis)].inside > kBoundsTicks)) {
        fail("the drive's own bounds are ignored though the axis is inside them");
    }
}

bool StationPromises::isHeld(Axis axis) const
{
    const fakes::IdealDrive& drive = axis == Axis::Azimuth ? m_rig.azimuth : m_rig.elevation;
    const bool obeys = drive.mode == moteus::Mode::Position && !drive.silent && !drive.deaf;
    return obeys && m_rig.mount.report(axis).hand == AxisHand::Follows;
}

// Only an axis that its drive does not hold may move while the brake is being set.
void StationPromises::watchBrake(const StationStatus& now)
{
    const bool isReleased = m_rig.control.releasesBrake();
    const bool areHeld = isHeld(Axis::Azimuth) && isHeld(Axis::Elevation);
    const auto moves = [](const AxisStatus& axis) {
        return axis.commandedRate.value_or(AngularRate{}) != AngularRate{};
    };
    if (m_isBrakeReleased && !isReleased && areHeld && m_wasHeld && (moves(now.azimuth) || moves(now.elevation))) {
        fail("the brake is set under a moving antenna");
    }
    m_isBrakeReleased = isReleased;
    m_wasHeld = areHeld;
}

// The real axis, whatever its drive reports.
void StationPromises::watchAxis(Axis axis, const StationStatus& now, Seconds step)
{
    const fakes::IdealDrive& drive = axis == Axis::Azimuth ? m_rig.azimuth : m_rig.elevation;
    const profile::AxisSettings& settings = m_rig.profile.axis(axis);
    AxisTrace& trace = m_traces[index(axis)];
    const auto degrees = [](double turns) { return std::abs(turns) * 360.0; };
    const double moved = degrees(drive.travelled - trace.travelled);
    const double time = std::min(step.count(), kLongestStep);
    trace.travelled = drive.travelled;
    // A drive that has missed commands catches up at once. On a released bus an ideal drive brakes when the bus is
    // back.
    const bool deaf = drive.silent || drive.deaf || drive.mode != moteus::Mode::Position || m_rig.mount.busLeft();
    trace.sinceSlip = deaf ? 0 : trace.sinceSlip + 1;
    trace.sinceFalse = drive.falsePlaces.empty() ? trace.sinceFalse + 1 : 0;
    const bool wasDeceived = trace.sinceHold <= kCaptureTicks && trace.sinceFalse <= kCaptureTicks;
    const bool isJudged = trace.sinceSlip > kSlipTicks && !wasDeceived;
    if (isJudged && moved > settings.limits.speed.degrees() * time * 1.001 + kPlaceNoise) {
        fail("an axis moves faster than the limit: by " + std::to_string(moved) + "° in a tick");
    }
    if (isJudged && m_sinceEnd > kStopTicks && moved > kPlaceNoise) {
        fail("an axis really moves though its motion was ended: by " + std::to_string(moved) + "°");
    }
    const TravelRange& travel = settings.geometry.travel;
    const Angle border = Angle::fromDegrees(kAtBorder);
    const Angle place = settings.geometry.toAxis(MotorTurns::fromTurns(drive.position));
    const bool inside = knows(now, axis) && place > travel.min + border && place < travel.max - border;
    trace.inside = inside ? trace.inside + 1 : 0;
}

void StationPromises::watchRegion(const StationStatus& now)
{
    const auto place = [](const StationStatus& status) -> std::optional<AxisPosition> {
        const bool known = status.azimuth.commanded && status.elevation.commanded && knowsBoth(status);
        return known ? std::optional(AxisPosition{*status.azimuth.commanded, *status.elevation.commanded})
                     : std::nullopt;
    };
    const auto is = place(now);
    const auto was = place(m_before);
    if (is && was && m_region.permits(*was) && !m_region.permits(*is) && !takesOver(Axis::Azimuth, now) &&
        !takesOver(Axis::Elevation, now)) {
        fail("a set-point enters a forbidden region: " + m_region.reason(*is).toStdString());
    }
}

void StationPromises::watchPath(Axis axis, const StationStatus& now, Seconds step)
{
    const AxisStatus& is = axisOf(now, axis);
    const AxisStatus& was = axisOf(m_before, axis);
    if (!is.commanded || !was.commanded || takesOver(axis, now) || !knowsBoth(now) || !knowsBoth(m_before)) {
        return;
    }
    const tracking::MotionLimits& limits = m_rig.profile.axis(axis).limits;
    const double time = std::min(step.count(), kLongestStep);
    const auto outside = [&](const AxisStatus& axisThen) {
        return std::max({0.0, (axisThen.travel.min - *axisThen.commanded).degrees(),
                         (*axisThen.commanded - axisThen.travel.max).degrees()});
    };
    if (outside(is) > outside(was) + 1e-6) {
        fail("a set-point leaves the travel");
    }
    if (abs(*is.commandedRate).degrees() > limits.speed.degrees() * 1.001) {
        fail("a set-point is faster than the limit");
    }
    // STOP may brake as hard as a drive that has lost its commands.
    const AngularAcceleration allowed = now.stopLatched ? tracking::emergencyBraking(limits) : limits.acceleration;
    const double moved = (*is.commanded - *was.commanded).degrees();
    const double mean = (is.commandedRate->degrees() + was.commandedRate->degrees()) / 2.0;
    if (std::abs(moved - mean * time) > allowed.degrees() * time * time) {
        fail("a step in position");
    }
    if (std::abs((*is.commandedRate - *was.commandedRate).degrees()) > allowed.degrees() * time * 1.01) {
        fail("a step in speed");
    }
}

}  // namespace boresight
