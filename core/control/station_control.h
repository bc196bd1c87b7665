// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/control/advice_alarms.h"
#include "core/control/antenna_choice.h"
#include "core/control/arming.h"
#include "core/control/cable_guard.h"
#include "core/control/client_control.h"
#include "core/control/client_desk.h"
#include "core/control/current_motion.h"
#include "core/control/first_moves_guard.h"
#include "core/control/gates.h"
#include "core/control/held_log.h"
#include "core/control/helm.h"
#include "core/control/motion_source.h"
#include "core/control/mount_desk.h"
#include "core/control/orderly_end.h"
#include "core/control/region_keeper.h"
#include "core/control/slew_watch.h"
#include "core/control/source_log.h"
#include "core/control/standstill_watch.h"
#include "core/control/status_report.h"
#include "core/control/target_alarm.h"
#include "core/control/wind_guard.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"
#include "core/motion/motion.h"
#include "core/mount/mount_driver.h"
#include "core/pointing/mount_model.h"
#include "core/profile/in_force.h"

#include <QString>

#include <optional>

// The only place that decides about motion: accepts or refuses every request, whoever sends it, and once per tick
// turns the decision into one set-point for each axis of the mount. Holds the rules: nothing moves before an explicit
// request, STOP latches, a fault or silence needs an explicit re-arm, the operator goes before the clients. Pure: time
// comes from the injected clock; the Station gives it a mount and a timer. States and rules: README.md.
//
// More than 15 members and 600 lines: it owns the parts of the control, each with a state of its own, keeps their order
// in a tick, and answers for them.
namespace boresight {

class StationControl
{
public:
    // Without a source of motion nothing moves.
    // All but the sources outlive this.
    StationControl(const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms,
                   MountDriver& mount, const MakeSources& sources);

    // Accepted, or the reason in words. Takes effect in the next tick.
    Result<> request(const Request& request, const Source& source);
    // A client has connected; `host` is its address without the port.
    // `readsOnly` by the profile.
    void clientCame(const Source& client, const std::string& host, bool readsOnly = false)
    {
        m_clientControl.came(client, host, readsOnly);
    }
    // The source is gone for good: a `Move` of its own ends, a stream stops at its last point.
    void sourceGone(const Source& source);
    // A client asks for a motion, also one that is refused before request() sees it.
    void clientAsked(const Source& client)
    {
        m_asked = m_now;
        m_clientControl.asked(client, m_now);
    }
    // A client has read the measured position: if the running stream is its own, it is content until it sends a
    // point.
    void positionRead(std::uint64_t clientId);

    // Judges what the mount reports, moves the set-points on and commands them.
    void tick();

    // The end of the program: decelerate, then bring the drives into the profile's `on_exit` state. Keep ticking until
    // shutDownDone().
    void shutDown();
    [[nodiscard]] bool shutDownDone() const { return m_end.done(); }

    [[nodiscard]] StationState state() const { return report().state(); }
    // Everything this class knows; bus, clients and server are left to the Station.
    [[nodiscard]] StationStatus status() const;
    // What the last tick commanded and what the drives have answered to it; empty before the first tick.
    [[nodiscard]] std::optional<TickSample> sample() const { return report().sample(); }
    // The mount still does what this source asked for last: nobody has ended it, nor asked for anything else.
    [[nodiscard]] bool obeys(const Source& source) const { return m_current.isFor(source) && moves(); }
    [[nodiscard]] bool followsClient() const { return m_current.commander().kind == SourceKind::Client && moves(); }
    // Another one each time that the mount is sent somewhere or given away; the operator's jogs and steps, Hold and
    // STOP leave it.
    [[nodiscard]] std::uint64_t motionId() const { return m_current.motionId(); }
    // The operator enters the cable wrap of the axis, or has entered it. It may differ from the one before.
    [[nodiscard]] bool isTurnAsked(Axis axis) const { return m_mount.report(axis).wrapAsked; }
    [[nodiscard]] Authority authority() const { return m_arming.authority(); }
    // Whether this source may send the mount anywhere now. The error names what is in the way.
    [[nodiscard]] Result<> mayPoint(const Source& source) const { return gates().mayPoint(source); }
    // Whether this source has the control, as far as the operator and the other clients are concerned.
    [[nodiscard]] Result<> mayCommand(const Source& source) const { return gates().mayCommand(source); }
    // Whether a shell of this computer may send the mount anywhere without taking the control from a client.
    [[nodiscard]] Result<> mayShellCommand() const { return gates().mayShellCommand(); }
    // Another client re-armed the drives; this one kept sending and has to act before it moves the mount.
    [[nodiscard]] bool waitsSinceRearm(const Source& client) const { return m_clientControl.waits(client.clientId); }
    // Whether the beam can be pointed there from where it is, by all that is permitted.
    [[nodiscard]] Result<> reaches(const SkyPointing& direction) const { return m_helm.reaches(direction); }
    // The profile lets the beam at the Sun itself.
    [[nodiscard]] Result<> mayFaceSun() const { return gates().mayFaceSun(); }
    // Whether the operator may send the mount there, by the gates that a go-to passes.
    [[nodiscard]] DirectionVerdict judge(const SkyPointing& direction) const { return m_helm.judge(direction); }
    [[nodiscard]] const pointing::PermittedRegion& region() const { return m_motion.region(); }
    // Those of the profile, as far as the rotator can go along.
    [[nodiscard]] const tracking::MotionLimits& limits(Axis axis) const { return m_motion.limits(axis); }
    // North and the terms of the pointing model are those of the main antenna.
    [[nodiscard]] Result<> usesMainAntenna() const { return gates().usesMainAntenna(); }
    // Whether other terms of the pointing model would leave the motion what it is.
    [[nodiscard]] Result<> mayChangePointing() const { return gates().mayChangePointing(); }
    // What a client may do now, into its part of the status; `lastMotion` is when it last asked for a motion.
    void describe(ClientStatus& client, const std::optional<SteadyTime>& lastMotion) const
    {
        m_clientDesk.describe(client, lastMotion);
    }
    // The axes as measured; an error when unknown or older than 1 s.
    [[nodiscard]] Result<AxisPosition> measured() const;
    // How that differs from what the axes show, as far as it is known with the axes that there are.
    [[nodiscard]] const pointing::PointingModel& pointing() const { return m_model.pointing(); }
    [[nodiscard]] bool isSeenToMove(Axis axis) const { return m_standstill.moves(axis); }
    // Where the beam of the antenna in use points, while that is known and measured within the last second.
    [[nodiscard]] std::optional<SkyPointing> direction() const;
    // The same by other terms of the pointing model: those of the profile are of the main antenna.
    [[nodiscard]] std::optional<SkyPointing> directionBy(const pointing::PointingTerms& terms) const;
    // What is added to the targets of the client that is followed now: it receives positions without it.
    [[nodiscard]] std::optional<AxisPosition> trimInUse() const;
    // Where the last point of the stream sends the axes: there, or to the nearest permitted place.
    [[nodiscard]] std::optional<AxisPosition> streamGoal() const;
    // The mount follows the stream of this client, or stays at its last point.
    [[nodiscard]] bool streamsFor(std::uint64_t clientId) const;
    // What the operator adds to whatever is followed.
    [[nodiscard]] const AxisPosition& trim() const { return m_motion.trim(); }
    // Both axes are this near to where they are sent.
    [[nodiscard]] bool onTarget(Angle within) const { return report().onTarget(within); }
    // Why not the target is driven but the nearest permitted place; empty: it is driven.
    [[nodiscard]] QString limitedReason() const { return report().limitedReason(); }
    [[nodiscard]] AlarmBoard& alarms() { return m_alarms; }
    // A drive was lost and nobody has re-armed yet; also while DISCONNECTED hides the word FAULT.
    [[nodiscard]] bool stopLatched() const { return m_arming.stopLatched(); }
    [[nodiscard]] bool faultLatched() const { return m_arming.fault().has_value(); }

    // What was worked out from the profile follows it: the region, the limits of a motion under way, the advice.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    [[nodiscard]] const MountDriver& mount() const { return m_mount; }
    [[nodiscard]] const pointing::Antenna& antenna() const { return m_antenna.inUse(); }
    // For what has no antenna of its own.
    [[nodiscard]] pointing::Antenna chosenAntenna() const { return m_antenna.chosen(); }
    // Where a sensor measures the main beam. It counts only when the wrap is asked for.
    void setSensor(const std::optional<Angle>& azimuth, const std::optional<Angle>& elevation);
    // What an anemometer reports, in m/s.
    void takeWind(double speed) { m_wind.take(speed); }
    // Why the wind lets only Park move the mount; empty: it forbids nothing.
    [[nodiscard]] QString windObstacle() const { return m_wind.obstacle(); }
    // For the source of motion that waits for it. The error says why it is not believed.
    Result<> receive(const SourceReport& received);

private:
    Result<> handle(const request::Hold& wanted, const Source& source);
    Result<> handle(const request::Stop& wanted, const Source& source);
    Result<> handle(const request::ResetStop& wanted, const Source& source);
    Result<> handle(const request::Rearm& wanted, const Source& source);
    Result<> handle(const request::AcknowledgeAlarms& wanted, const Source& source);
    Result<> handle(const request::ClearTrim& wanted, const Source& source);
    Result<> handle(const request::HoldAtEnd& wanted, const Source& source);
    Result<> handle(const request::AcknowledgeAlarm& wanted, const Source& source);
    Result<> handle(const request::OverrideWind& wanted, const Source& source);
    Result<> handle(const request::UseAntenna& wanted, const Source& source);
    Result<> handle(const request::ApplyProfile& wanted, const Source& source);
    Result<> handle(const request::Reconnect& wanted, const Source& source);

    Result<> askSources(const Request& request, const Source& source);

    [[nodiscard]] ControlParts parts() const;
    [[nodiscard]] StatusReport report() const { return StatusReport(parts()); }
    [[nodiscard]] Gates gates() const { return Gates(parts()); }
    [[nodiscard]] bool moves() const { return m_current.moves(); }
    [[nodiscard]] bool turnsKnown() const { return m_mount.wrapsKnown(); }
    void watchFirstMoves();
    void takeOver(const Source& source) { m_helm.takeOver(source); }
    void tell(Severity severity, const Source& source, const QString& what) { m_sourceLog.add(severity, source, what); }
    void holdHere(Activity left) { m_helm.hold(left); }
    void superviseMount();
    void keepStopped();
    void stepProof();
    void stepSources();
    void releaseAntenna();
    void watchInterlock();
    void watchRegion();
    void watchSun() { m_region.step(); }
    void watchCable();
    void watchLimited() { m_targetAlarm.update(limitedReason()); }
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
    SourceLog m_sourceLog;
    HeldLog m_heldLog;

    CurrentMotion m_current;
    FirstMovesGuard m_firstMoves;
    Helm m_helm;
    RegionKeeper m_region;
    ClientDesk m_clientDesk;
    MountDesk m_mountDesk;
    TargetAlarm m_targetAlarm;
    AdviceAlarms m_adviceAlarms;
    OrderlyEnd m_end;
    SteadyTime m_now{};    // of the running or last tick
    SteadyTime m_asked{};  // somebody asked for something last
    std::uint64_t m_tick = 0;
    MotionSources m_sources;
};

}  // namespace boresight
