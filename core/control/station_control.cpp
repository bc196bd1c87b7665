// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/station_control.h"

#include "core/base/text.h"
#include "core/mount/mount_service.h"

#include <algorithm>
#include <type_traits>

namespace boresight {
namespace {

// The longest step of the set-points. After a late tick (a stalled computer) the mount gets slower and never jumps.
constexpr Seconds kLongestStep{0.1};

// Requests that the station or one of its desks carries out. The desks request their motions like all other sources.
template <class Wanted>
constexpr bool kIsCarriedOutAbove =
    std::is_same_v<Wanted, CalibrationRequest> || std::is_same_v<Wanted, TuningRequest> ||
    std::is_same_v<Wanted, ScheduleRequest> || std::is_same_v<Wanted, request::Rehearse> ||
    std::is_same_v<Wanted, request::JudgeDirection> || std::is_same_v<Wanted, request::TrackFile> ||
    std::is_same_v<Wanted, request::UseNewTime> || std::is_same_v<Wanted, request::LogProtocol>;

}  // namespace

StationControl::StationControl(const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms,
                               MountDriver& mount, const MakeSources& sources)
    : m_profile(profile),
      m_clock(clock),
      m_log(log),
      m_alarms(alarms),
      m_mount(mount),
      m_antenna(profile, log, [this] { m_region.antennaChanged(); }),
      m_model(profile->azimuth.geometry, profile->elevation.geometry, pointing::PointingModel(profile->pointing)),
      m_motion(*profile, mount.capabilities()),
      m_arming(profile, mount, log),
      m_cable(m_alarms, clock),
      m_wind(profile, clock, alarms),
      m_brake({.profile = profile, .mount = mount, .motion = m_motion, .standstill = m_standstill, .alarms = alarms}),
      m_endSwitches({.profile = profile, .mount = mount, .motion = m_motion, .alarms = alarms}),
      m_sourceLog(log, clock),
      m_heldLog(m_sourceLog),
      m_helm({.motion = m_motion,
              .mount = m_mount,
              .current = m_current,
              .arming = m_arming,
              .clientControl = m_clientControl,
              .cable = m_cable,
              .firstMoves = m_firstMoves,
              .log = m_sourceLog,
              .alarms = m_alarms,
              .antenna = m_antenna},
             [this] { return parts(); }),
      m_region({.profile = m_profile,
                .antenna = m_antenna,
                .clock = clock,
                .model = m_model,
                .motion = m_motion,
                .helm = m_helm,
                .alarms = m_alarms,
                .log = log}),
      m_clientDesk(m_helm, m_arming, m_clientControl, log),
      m_mountDesk(mount, m_helm, log),
      m_operatorDesk({.helm = m_helm,
                      .antenna = m_antenna,
                      .wind = m_wind,
                      .brake = m_brake,
                      .clock = clock,
                      .alarms = alarms,
                      .log = log}),
      m_thirdAxis({.profile = profile, .mount = mount, .arming = m_arming, .log = log}),
      m_targetAlarm(m_alarms),
      m_adviceAlarms(m_alarms),
      m_now(clock.now()),
      m_sources(sources(m_helm))
{
    for (const Axis axis : kAxes) {
        if (!mount.capabilities().has(axis)) {
            m_model.leaveOut(axis);
        }
    }
    m_region.begin();
    m_adviceAlarms.update(*profile);
    m_adviceAlarms.explain(mount.capabilities());
}

ControlParts StationControl::parts() const
{
    return {.profile = *m_profile,
            .clock = m_clock,
            .model = m_model,
            .antenna = m_antenna,
            .mount = m_mount,
            .motion = m_motion,
            .standstill = m_standstill,
            .current = m_current,
            .arming = m_arming,
            .clientControl = m_clientControl,
            .cable = m_cable,
            .sun = m_region.sun(),
            .slew = m_slew,
            .energy = m_energy,
            .wind = m_wind,
            .brake = m_brake,
            .endSwitches = m_endSwitches,
            .alarms = m_alarms,
            .now = m_now,
            .asked = m_asked,
            .tick = m_tick};
}

Result<> StationControl::request(const Request& request, const Source& source)
{
    const auto answer = [&]<class Wanted>(const Wanted& wanted) -> Result<> {
        if constexpr (MotionRequests::has<Wanted>) {
            return askSources(request, source);
        } else if constexpr (requires { m_clientDesk.ask(wanted, source); }) {
            return m_clientDesk.ask(wanted, source);
        } else if constexpr (requires { m_operatorDesk.ask(wanted, source); }) {
            return m_operatorDesk.ask(wanted, source);
        } else if constexpr (requires { m_mountDesk.ask(wanted, source); }) {
            return m_mountDesk.ask(wanted, source);
        } else if constexpr (requires { m_thirdAxis.ask(wanted, source); }) {
            return m_thirdAxis.ask(wanted, source);
        } else if constexpr (kIsCarriedOutAbove<Wanted>) {
            return operatorOnly(source);
        } else {
            return handle(wanted, source);  // a request without a handler does not compile
        }
    };
    if (!std::holds_alternative<request::JudgeDirection>(request)) {
        m_asked = m_now;
    }
    return std::visit(answer, request);
}

StationStatus StationControl::status() const
{
    return described(report().status());
}

StationStatus StationControl::briefStatus() const
{
    return described(report().brief());
}

// Adds what the parts of this class know.
StationStatus StationControl::described(StationStatus status) const
{
    status.profile = m_profile.shared();
    status.wind = m_wind.status();
    status.brake = m_brake.status();
    status.endSwitches = m_endSwitches.status();
    m_thirdAxis.describe(status);
    m_sources.describe(status);
    return status;
}

Result<> StationControl::askSources(const Request& request, const Source& source)
{
    if (source.kind == SourceKind::Client) {
        clientAsked(source);
    }
    return m_sources.ask(request, source);
}

void StationControl::sourceGone(const Source& source)
{
    m_clientControl.gone(source);
    m_sources.gone(source);
}

void StationControl::positionRead(std::uint64_t clientId)
{
    m_clientControl.read(clientId, m_now);
    m_sources.positionRead(clientId);
}

Result<> StationControl::handle(const request::Hold&, const Source& source)
{
    if (const Result<> may = gates().mayLeavePark(); !may) {
        return source.kind == SourceKind::Client ? Result<>{} : may;  // for a client nothing moves, as it wants
    }
    takeOver(source);  // otherwise the next target of a client would undo the hold
    if (moves()) {
        tell(Severity::Advisory, source, Text::tr("ends the motion, and the mount holds"));
        holdHere(Activity::Holding);
        m_current.setHeldBy(source);
    }
    return {};
}

Result<> StationControl::handle(const request::Stop&, const Source& source)
{
    if (!m_arming.stopLatched()) {
        m_log.add(Severity::Warning, source.name, Text::tr("STOP is latched, and the mount decelerates and holds"));
    }
    takeOver(source);
    m_arming.latchStop();
    keepStopped();
    holdHere(Activity::None);
    return {};
}

Result<> StationControl::handle(const request::ResetStop&, const Source& source)
{
    return gates().mayResetStop().and_then([this] { return m_arming.resetStop(); }).map([&] {
        m_log.add(Severity::Advisory, source.name, Text::tr("resets STOP, and nothing moves until the next command"));
    });
}

// A client may re-arm only while it may move the mount. It re-arms only for itself: other clients that kept sending
// wait.
Result<> StationControl::handle(const request::Rearm&, const Source& source)
{
    if (source.kind != SourceKind::Client) {
        if (m_thirdAxis.recover(source) && !faultLatched()) {
            return {};
        }
        return m_arming.mayRearm(source).and_then([&] {
            takeOver(source);
            return m_arming.rearm(source);
        });
    }
    return m_clientControl.mayAct(m_profile->rotctld, source, m_now).and_then([&]() -> Result<> {
        if (!faultLatched() && m_clientControl.waits(source.clientId)) {
            m_clientControl.acted(source);
            return {};
        }
        return m_arming.rearm(source).map([&] { m_clientControl.rearmed(source, m_now); });
    });
}

void StationControl::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (before.mount.directions != after.mount.directions) {
        m_firstMoves.beginAnew();  // the permitted 2° begin where the mount stands now
    }
    m_standstill.forget();
    m_wind.profileChanged(before, after);
    m_brake.profileChanged(before, after);
    m_endSwitches.profileChanged(before, after);
    m_antenna.profileChanged(before, after);
    m_region.profileChanged(before, after);
    for (const Axis axis : kAxes) {
        m_motion.setLimits(axis, after.axis(axis).limits);
    }
    m_motion.setArrival(after.control.arrival);
    m_slew.lookAgain();
    m_adviceAlarms.update(after);
    m_sources.profileChanged(before, after);
}

// Returns to the chosen antenna when the mount rests. A place of the axes does not depend on the antenna.
void StationControl::releaseAntenna()
{
    const StationState now = state();
    const bool rests = !moves() || now == StationState::Parked;
    if (rests && now != StationState::Calibrate) {
        m_antenna.release();
    }
}

void StationControl::watchFirstMoves()
{
    if (m_firstMoves.exceeded(parts())) {
        m_helm.end(Severity::Advisory, Text::tr("jog ends at 2° until the directions of the axes are confirmed"));
    }
}

void StationControl::setSensor(const std::optional<Angle>& azimuth, const std::optional<Angle>& elevation)
{
    const SkyPointing beam{.azimuth = azimuth.value_or(Angle{}), .elevation = elevation.value_or(Angle{})};
    pointing::MountModel model = m_model;
    model.setPointing(pointing::PointingModel(m_profile->pointing));
    const AxisPosition axes = model.pointing().toAxes(beam).axes;
    m_mount.setSensor(Axis::Azimuth, azimuth ? std::optional(axes.azimuth) : std::nullopt);
    m_mount.setSensor(Axis::Elevation, elevation ? std::optional(axes.elevation) : std::nullopt);
}

void StationControl::tick()
{
    const SteadyTime now = m_clock.now();
    const Seconds step = std::clamp(Seconds(now - m_now), Seconds(0.0), kLongestStep);
    m_now = now;
    ++m_tick;
    // First, because everything below uses the replies of this tick.
    m_mount.observe(now);
    // After the replies, and before all parts that ask whether an axis stands.
    for (const Axis axis : kAxes) {
        m_standstill.look(axis, m_mount.report(axis));
    }
    // Before the supervision, which would treat a lost bus as a trouble of each axis.
    if (m_arming.losesConnection(now)) {
        holdHere(Activity::None);
    }
    // Before every source, because an axis that was lost in this tick must not move on.
    superviseMount();
    // After the supervision, because a drive that was lost in this tick may not hold its axis any more.
    watchBrake();
    // Before every source, because a mount that runs into a closed end must not move on.
    watchEndSwitches();
    // After the supervision, because only then it is known which drives are back. A drive that moves in spite of STOP
    // is stopped again. This is before the sources, so that they find the drive stopped.
    keepStopped();
    // Before the sources: in a strong wind one source parks the mount, and the others are refused.
    m_wind.step();
    // After STOP and faults are known, so that no source begins a motion which they forbid.
    m_sources.step(m_now);
    // After the sources, because a source may have ended its tracking.
    releaseAntenna();
    // After the sources: a motion that they have just begun ends here if it is not permitted.
    watchFirstMoves();
    // After the sources, because the interlock is checked for the motion, not for its source.
    watchInterlock();
    // After the losses of this tick, because a loss begins the re-arm again.
    finishRearm();
    // After all parts that can end a motion, because the crash-stop proof is a motion. moveOn() carries out its step.
    stepProof();
    // Directly before the set-points, which respect the keep-out of this tick.
    watchSun();
    // After all parts that begin, hold or end the motion. The set-points of this tick carry out the result.
    moveOn(step);
    // After STOP and the faults of this tick are known, because they end its jog.
    m_thirdAxis.step(step, now);
    // After the set-points. Only now it is known what holds them, how much cable is left, and whether the target is
    // reached.
    watchRegion();
    watchCable();
    watchLimited();
    m_wind.tell(m_current.is(Activity::Parking) || gates().isAtPark());
    // After all parts that can begin or end the motion. It looks ahead along the rest of the way.
    m_slew.update(m_mount.follows() && state() == StationState::Slew, m_motion, now);
    // After the set-points: they determine the state, and the energy of this tick counts for that state.
    const StationState then = state();
    const bool moves = then == StationState::Slew || then == StationState::Track || then == StationState::Jog;
    m_energy.look(m_mount, moves, m_current.motionId(), now);
    // After all parts that raise or clear an alarm.
    m_alarms.tick();
    // Last: the drives are left when the set-points of this tick stand still.
    const bool stands = m_motion.atRest() && !m_mount.changesHands() && m_thirdAxis.atRest();
    if (m_end.leaves(stands && m_brake.isSet(), m_now)) {
        // Without torque and without a brake the antenna would fall.
        m_mount.leave(m_brake.isSet() ? m_profile->control.onExit : profile::OnExit::Hold);
        m_thirdAxis.leave(m_profile->control.onExit);
    }
}

// A trouble ends the motion. The axes brake from their set-points.
void StationControl::superviseMount()
{
    const MountFindings found = m_mount.supervise({.wanted = !m_current.is(Activity::None),
                                                   .settled = m_motion.atRest(),
                                                   .faultLatched = faultLatched(),
                                                   .stopLatched = m_arming.stopLatched(),
                                                   .closing = m_arming.closing()});
    if (found.homed) {
        m_endSwitches.homed();
    }
    if (found.interrupted) {
        holdHere(Activity::None);
    }
    for (const AxisTrouble& trouble : found.troubles) {
        m_arming.lost(trouble.axis, trouble.loss, trouble.what);
        holdHere(Activity::None);
    }
}

// A brake output that fails during a motion is a fault of the mount: the brake may be set or not.
void StationControl::watchBrake()
{
    const bool isUrgent = m_arming.stopLatched() || faultLatched() || m_arming.closing();
    if (const QString why = m_brake.step(isUrgent, m_now); !why.isEmpty()) {
        const Axis axis = m_mount.capabilities().has(Axis::Azimuth) ? Axis::Azimuth : Axis::Elevation;
        m_arming.lost(axis, supervision::LossClass::Motion, why);
        holdHere(Activity::None);
    }
}

// An axis at its end switch is where it must never be: this is a fault of the mount.
void StationControl::watchEndSwitches()
{
    if (const auto hit = m_endSwitches.step(faultLatched(), m_mount.available().has_value(), m_now)) {
        m_arming.lost(hit->axis, supervision::LossClass::Motion, hit->why);
        holdHere(Activity::None);
    }
}

// While STOP is latched, commands of another program must not move an axis either. A drive may still have such a
// command when it is back.
void StationControl::keepStopped()
{
    if (m_arming.stopLatched() && m_mount.available() && !m_arming.closing()) {
        m_mount.seize();
    }
}

void StationControl::stepProof()
{
    if (!m_mount.proofRunning() || !m_brake.isOpen()) {
        return;
    }
    const MountService::ProofStep step = m_mount.service()->stepProof();
    if (step.run) {
        m_motion.run(*step.run);
    }
    if (step.rest) {
        m_motion.rest();
    }
    if (step.ended) {
        holdHere(Activity::Holding);
    }
}

void StationControl::watchCable()
{
    const bool isForecast = m_current.needsForecast() && turnsKnown() && !pointing().isXY();
    const auto path = isForecast ? m_motion.path(m_now) : std::nullopt;
    const auto target = moves() && m_motion.noWay().isEmpty() ? m_motion.target(m_now) : std::nullopt;
    const auto left = target ? std::optional(target->azimuth - m_motion.place().azimuth) : std::nullopt;
    m_cable.watch(path, left, m_motion.region().ranges().azimuth, m_motion.limits(Axis::Azimuth), m_current.keepsWrap(),
                  whereabouts().cableEnd());
}

// Where the operator chose to wait at the cable end instead of unwrapping, the alarm about the cable gives the reason.
void StationControl::watchLimited()
{
    const std::optional<Angle> end = whereabouts().cableEnd();
    const bool isChosen =
        end && m_current.keepsWrap() && CableGuard::hasOtherWrap(*end, m_motion.region().ranges().azimuth);
    m_targetAlarm.update(isChosen ? QString() : limitedReason());
}

// Ends the motion when an interlock appears, for example because a drive is not safe any more.
void StationControl::watchInterlock()
{
    if (!m_mount.interlock() && moves() && (!m_motion.atRest() || m_brake.opens())) {
        m_log.add(Severity::Warning, QStringLiteral("station"),
                  Text::tr("ends the motion: %1").arg(m_mount.interlock().error().text));
        holdHere(Activity::Holding);
    }
}

// Ends a motion that has no permitted way left after a change of the region. A stream of a client waits instead.
void StationControl::watchRegion()
{
    if (m_current.goesToAPlace() && !m_motion.noWay().isEmpty()) {
        m_log.add(Severity::Warning, QStringLiteral("station"), Text::tr("ends the motion: %1").arg(m_motion.noWay()));
        holdHere(Activity::Holding);
    }
    m_heldLog.look(m_current, m_motion);
}

void StationControl::finishRearm()
{
    if (!m_arming.completesRearm()) {
        return;
    }
    m_mount.rearmed();
    m_log.add(Severity::Advisory, QStringLiteral("station"), Text::tr("re-armed, and nothing moves"));
}

void StationControl::moveOn(Seconds step)
{
    for (const Axis axis : kAxes) {
        if (const auto place = m_mount.takeFollowing(axis)) {
            m_motion.start(axis, *place);
        }
        m_motion.close(axis, m_endSwitches.closed(axis));
    }
    m_motion.enforceRegion(turnsKnown());
    m_motion.setSeen(m_mount.measured());
    const bool brakesHard = m_arming.stopLatched() || m_endSwitches.isUrgent();
    m_motion.setHardBraking(brakesHard);
    m_mount.brakeHard(brakesHard);
    if (m_mount.follows() && m_mount.seen() && m_brake.letsMove(m_now, step)) {
        m_motion.advance(m_now, step);
        if (m_motion.stray()) {
            m_mount.retake();
        }
    } else {
        m_motion.brake(step);  // no motion with one axis alone, with an unknown place or before the brake is open
    }
    m_motion.setBand(FirstMovesGuard::band(*m_profile, m_antenna.inUse()));
    const auto leeway = m_motion.leeway(m_now);
    for (const Axis axis : kAxes) {
        m_mount.command(axis, m_motion.setpoint(axis));
        m_mount.setLeeway(axis, leeway[index(axis)]);
    }
}

void StationControl::shutDown()
{
    if (m_end.begin(*m_profile, m_clock.now())) {
        m_arming.close();
        holdHere(Activity::None);
    }
}

}  // namespace boresight
