// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/control/advice_alarms.h"
#include "core/control/antenna_choice.h"
#include "core/control/arming.h"
#include "core/control/client_control.h"
#include "core/control/client_desk.h"
#include "core/control/current_motion.h"
#include "core/control/first_moves_guard.h"
#include "core/control/gates.h"
#include "core/control/held_log.h"
#include "core/control/helm.h"
#include "core/control/mount_desk.h"
#include "core/control/operator_desk.h"
#include "core/control/orderly_end.h"
#include "core/control/region_keeper.h"
#include "core/control/slew_watch.h"
#include "core/control/source_list.h"
#include "core/control/source_log.h"
#include "core/control/status_report.h"
#include "core/control/target_alarm.h"
#include "core/control/third_axis_jog.h"
#include "core/control/whereabouts.h"
#include "core/guards/brake_guard.h"
#include "core/guards/cable_guard.h"
#include "core/guards/end_switch_guard.h"
#include "core/guards/standstill_watch.h"
#include "core/guards/wind_guard.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"
#include "core/motion/motion.h"
#include "core/mount/mount_driver.h"
#include "core/pointing/mount_model.h"
#include "core/profile/in_force.h"

#include <QString>

#include <optional>

// The only place that decides about motion. Accepts or refuses the requests of all sources. Once per tick, turns the
// decision into one set-point for each axis of the mount. The rules: nothing moves before an explicit request, STOP
// latches, a fault or silence needs an explicit re-arm, the operator goes before the clients. Pure: time comes from the
// injected clock; the Station gives it a mount and a timer. States and rules: README.md.
//
// More than 15 members and 600 lines: it owns the parts of the control, each with a state of its own. It calls them in
// a fixed order in each tick, and answers questions for them.
namespace boresight {

class StationControl
{
public:
    // All arguments but the sources outlive this. Without a source of motion nothing moves.
    StationControl(const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms,
                   MountDriver& mount, const MakeSources& sources);

    // Accepts the request, or returns the reason for a refusal. It takes effect in the next tick.
    Result<> request(const Request& request, const Source& source);
    // A client has connected. `host` is its address without the port. `readsOnly` comes from the profile.
    void clientCame(const Source& client, const std::string& host, bool readsOnly = false)
    {
        m_clientControl.came(client, host, readsOnly);
    }
    // The source is gone for good. Its `Move` ends. Its stream stops at the last point.
    void sourceGone(const Source& source);
    // A client asks for a motion. Call this also for a motion that is refused before request().
    void clientAsked(const Source& client)
    {
        m_asked = m_now;
        m_clientControl.asked(client, m_now);
    }
    // A client has read the measured position. A client that reads while its stream runs is satisfied with its last
    // point.
    void positionRead(std::uint64_t clientId);

    // Judges the reports of the mount, moves the set-points on and sends them.
    void tick();

    // Begins the end of the program: decelerates the mount, then brings the drives into the state `on_exit` of the
    // profile. Keep ticking until shutDownDone().
    void shutDown();
    [[nodiscard]] bool shutDownDone() const { return m_end.done(); }

    [[nodiscard]] StationState state() const { return report().state(); }
    // The status of all parts of this class. The Station adds bus, clients and server.
    [[nodiscard]] StationStatus status() const;
    // The same without permissions and route, for those that look at it in each tick.
    [[nodiscard]] StationStatus briefStatus() const;
    // The set-points of the last tick and the replies of the drives to them. Empty before the first tick.
    [[nodiscard]] std::optional<TickSample> sample() const { return report().sample(); }
    // Whether the mount still carries out the last motion of this source.
    [[nodiscard]] bool obeys(const Source& source) const { return m_current.isFor(source) && moves(); }
    // Who asked the mount to hold since its last motion began. Empty: nobody.
    [[nodiscard]] const std::optional<Source>& heldBy() const { return m_current.heldBy(); }
    [[nodiscard]] bool followsClient() const { return m_current.commander().kind == SourceKind::Client && moves(); }
    // Changes each time that the mount is sent somewhere or control is given away. Jogs and steps of the operator, Hold
    // and STOP do not change it.
    [[nodiscard]] std::uint64_t motionId() const { return m_current.motionId(); }
    // Whether the operator is asked for the cable wrap of the axis. The wrap may then differ from the previous one.
    [[nodiscard]] bool isTurnAsked(Axis axis) const { return m_mount.report(axis).wrapAsked; }
    [[nodiscard]] Authority authority() const { return m_arming.authority(); }
    // Whether this source may send the mount to a place now. The error names what is in the way.
    [[nodiscard]] Result<> mayPoint(const Source& source) const { return gates().mayPoint(source); }
    // Whether the operator and the other clients leave control to this source.
    [[nodiscard]] Result<> mayCommand(const Source& source) const { return gates().mayCommand(source); }
    // Whether a shell of this computer may send the mount to a place without taking control from a client.
    [[nodiscard]] Result<> mayShellCommand() const { return gates().mayShellCommand(); }
    // Whether this client must act before it may move the mount: another client re-armed the drives meanwhile.
    [[nodiscard]] bool waitsSinceRearm(const Source& client) const { return m_clientControl.waits(client.clientId); }
    // Whether the beam can be pointed there from its present place, within everything that is permitted.
    [[nodiscard]] Result<> reaches(const SkyPointing& direction) const { return m_helm.reaches(direction); }
    // Whether the profile permits the beam to point at the Sun.
    [[nodiscard]] Result<> mayFaceSun() const { return gates().mayFaceSun(); }
    // Whether the operator may send the mount there, judged by the gates of a go-to.
    [[nodiscard]] DirectionVerdict judge(const SkyPointing& direction) const { return m_helm.judge(direction); }
    [[nodiscard]] const pointing::PermittedRegion& region() const { return m_motion.region(); }
    // The motion limits of the profile, reduced to what the rotator can do.
    [[nodiscard]] const tracking::MotionLimits& limits(Axis axis) const { return m_motion.limits(axis); }
    // Whether the main antenna is in use. North and the pointing model are measured with it.
    [[nodiscard]] Result<> usesMainAntenna() const { return gates().usesMainAntenna(); }
    // Whether the terms of the pointing model may change, which must not change a running motion.
    [[nodiscard]] Result<> mayChangePointing() const { return gates().mayChangePointing(); }
    // Fills in what the client may do now. `lastMotion` is when it last asked for a motion.
    void describe(ClientStatus& client, const std::optional<SteadyTime>& lastMotion) const
    {
        m_clientDesk.describe(client, lastMotion);
    }
    // The measured axis angles. An error when they are unknown or older than 1 s.
    [[nodiscard]] Result<AxisPosition> measured() const { return whereabouts().measured(); }
    // The difference between true directions and axis angles, as far as it is known for the axes of this mount.
    [[nodiscard]] const pointing::PointingModel& pointing() const { return m_model.pointing(); }
    [[nodiscard]] bool isSeenToMove(Axis axis) const { return m_standstill.moves(axis); }
    // Where the beam of the antenna in use points. Empty when that is unknown or older than 1 s.
    [[nodiscard]] std::optional<SkyPointing> direction() const { return whereabouts().direction(); }
    // The same with other terms of the pointing model. The terms of the profile give the main beam.
    [[nodiscard]] std::optional<SkyPointing> directionBy(const pointing::PointingTerms& terms) const
    {
        return whereabouts().directionBy(terms);
    }
    // The trim that is added to the targets of the client that is followed. The client gets positions without it.
    [[nodiscard]] std::optional<AxisPosition> trimInUse() const { return whereabouts().trimInUse(); }
    // The axis angles for the last point of the stream: the point itself, or the nearest permitted place.
    [[nodiscard]] std::optional<AxisPosition> streamGoal() const { return whereabouts().streamGoal(); }
    // The last point of a client as it was asked for, while the mount goes there or stays there.
    [[nodiscard]] const std::optional<SkyPointing>& askedPoint() const { return m_current.asked(); }
    // Where the axes go. If they go nowhere: where they stop or stand. It is without the trim, which is added to
    // points.
    [[nodiscard]] AxisPosition untrimmedGoal() const { return whereabouts().untrimmedGoal(); }
    // The correction by the operator that is added to every target that is tracked.
    [[nodiscard]] const AxisPosition& trim() const { return m_motion.trim(); }
    // How well the points that are followed show their target. Empty: no stream of points is followed.
    [[nodiscard]] std::optional<tracking::StreamError> streamError() const { return m_motion.streamError(m_now); }
    // Whether both axes are this near to their target.
    [[nodiscard]] bool onTarget(Angle within) const { return report().onTarget(within); }
    // Why the mount goes to the nearest permitted place instead of the target. Empty: it goes to the target.
    [[nodiscard]] QString limitedReason() const { return report().limitedReason(); }
    [[nodiscard]] AlarmBoard& alarms() { return m_alarms; }
    [[nodiscard]] bool stopLatched() const { return m_arming.stopLatched(); }
    // A drive was lost and nobody has re-armed yet. Also true in the state DISCONNECTED, which hides FAULT.
    [[nodiscard]] bool faultLatched() const { return m_arming.fault().has_value(); }

    // Updates what is computed from the profile: the region, the limits of a motion under way, the advice.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    [[nodiscard]] const MountDriver& mount() const { return m_mount; }
    [[nodiscard]] const pointing::Antenna& antenna() const { return m_antenna.inUse(); }
    // The antenna that is used for targets without an antenna of their own.
    [[nodiscard]] pointing::Antenna chosenAntenna() const { return m_antenna.chosen(); }
    // Where a sensor measures the main beam. It counts only while the operator is asked for the wrap.
    void setSensor(const std::optional<Angle>& azimuth, const std::optional<Angle>& elevation);
    // A reading of the anemometer, in m/s.
    void takeWind(double speed) { m_wind.take(speed); }
    // Why no reading comes from the anemometer. Empty: no trouble is known.
    void takeWindTrouble(const QString& trouble) { m_wind.takeTrouble(trouble); }
    // What the output of the brakes answers, before each tick, and the order to the output after the tick.
    void takeBrake(const contacts::OutputAnswer& answer) { m_brake.take(answer); }
    [[nodiscard]] bool releasesBrake() const { return m_brake.releases(); }
    // What the inputs of the end switches read, before each tick.
    void takeEndSwitches(const EndSwitchGuard::Readings& readings) { m_endSwitches.take(readings); }
    // Why only Park may move the mount because of the wind. Empty: the wind forbids nothing.
    [[nodiscard]] QString windObstacle() const { return m_wind.obstacle(); }
    // Where the target that is tracked by the time is at this time. Empty: none is tracked, or the direction is
    // unknown.
    [[nodiscard]] std::optional<SkyPointing> targetAt(UtcTime utc) { return m_sources.targetAt(utc); }
    // Passes a report to the source of motion that waits for it. The error explains why the report is not believed.
    Result<> receive(const SourceReport& received) { return m_sources.receive(received); }

private:
    Result<> handle(const request::Hold& wanted, const Source& source);
    Result<> handle(const request::Stop& wanted, const Source& source);
    Result<> handle(const request::ResetStop& wanted, const Source& source);
    Result<> handle(const request::Rearm& wanted, const Source& source);

    Result<> askSources(const Request& request, const Source& source);

    [[nodiscard]] ControlParts parts() const;
    [[nodiscard]] StatusReport report() const { return StatusReport(parts()); }
    [[nodiscard]] StationStatus described(StationStatus status) const;
    [[nodiscard]] Gates gates() const { return Gates(parts()); }
    [[nodiscard]] Whereabouts whereabouts() const { return Whereabouts(parts()); }
    [[nodiscard]] bool moves() const { return m_current.moves(); }
    [[nodiscard]] bool turnsKnown() const { return m_mount.wrapsKnown(); }
    void watchFirstMoves();
    void takeOver(const Source& source) { m_helm.takeOver(source); }
    void tell(Severity severity, const Source& source, const QString& what) { m_sourceLog.add(severity, source, what); }
    void holdHere(Activity left) { m_helm.hold(left); }
    void superviseMount();
    void watchBrake();
    void watchEndSwitches();
    void keepStopped();
    void stepProof();
    void releaseAntenna();
    void watchInterlock();
    void watchRegion();
    void watchSun() { m_region.step(); }
    void watchCable();
    void watchLimited();
    void finishRearm();
    void moveOn(Seconds step);

    const profile::InForce& m_profile;
    const Clock& m_clock;
    EventLog& m_log;
    AlarmBoard& m_alarms;
    MountDriver& m_mount;
    AntennaChoice m_antenna;
    pointing::MountModel m_model;
    Motion m_motion;
    StandstillWatch m_standstill;
    Arming m_arming;
    ClientControl m_clientControl;
    CableGuard m_cable;
    SlewWatch m_slew;
    EnergyMeter m_energy;
    WindGuard m_wind;
    BrakeGuard m_brake;
    EndSwitchGuard m_endSwitches;
    SourceLog m_sourceLog;
    HeldLog m_heldLog;

    CurrentMotion m_current;
    FirstMovesGuard m_firstMoves;
    Helm m_helm;
    RegionKeeper m_region;
    ClientDesk m_clientDesk;
    MountDesk m_mountDesk;
    OperatorDesk m_operatorDesk;
    ThirdAxisJog m_thirdAxis;
    TargetAlarm m_targetAlarm;
    AdviceAlarms m_adviceAlarms;
    OrderlyEnd m_end;
    SteadyTime m_now{};    // time of the running or last tick
    SteadyTime m_asked{};  // time of the last request
    std::uint64_t m_tick = 0;
    SourceList m_sources;
};

}  // namespace boresight
