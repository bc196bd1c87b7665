// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/alarms/log_throttle.h"
#include "core/axes/drive_pair.h"
#include "core/axes/drive_watch.h"
#include "core/axes/first_moves.h"
#include "core/axes/motion.h"
#include "core/axes/turn_keeper.h"
#include "core/base/can_frame.h"
#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/control/arming.h"
#include "core/control/cable_guard.h"
#include "core/control/client_lead.h"
#include "core/control/current_motion.h"
#include "core/control/gates.h"
#include "core/control/orderly_end.h"
#include "core/control/proof_run.h"
#include "core/control/stall_guard.h"
#include "core/control/status_report.h"
#include "core/control/sun_alarms.h"
#include "core/control/sun_watch.h"
#include "core/control/turn_watch.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"
#include "core/pointing/mount_model.h"
#include "core/profile/advice.h"
#include "core/profile/profile.h"
#include "core/survey/drive_survey.h"

#include <QString>

#include <array>
#include <optional>
#include <vector>

// The only place that decides about motion: accepts or refuses every request, whoever sends it, and once per tick
// turns the decision into one frame for each drive. Holds the rules: nothing moves before an explicit request, STOP
// latches, a fault or silence needs an explicit re-arm, the operator goes before the clients. Pure: frames in, frames
// out, time from the injected clock; the Station gives it a bus and a timer. States and rules: README.md.
namespace boresight {

class StationControl
{
public:
    StationControl(const profile::Profile& profile, const Clock& clock, EventLog& log, TurnKeeper::Start start = {});

    // Accepted, or the reason in words. Takes effect in the next tick.
    Result<> request(const Request& request, const Source& source);
    // A client has connected; `host` is its address without the port.
    void clientCame(const Source& client, const std::string& host) { m_lead.came(client, host); }
    // The source is gone for good: a `Move` of its own ends, a stream comes to rest at its last point.
    void sourceGone(const Source& source);
    // A client asks for a motion, also one that is refused before request() sees it.
    void clientAsked(const Source& client) { m_lead.asked(client, m_now); }
    // A client has read the measured position: if the running stream is its own, it is content until it sends a
    // point.
    void positionRead(std::uint64_t clientId);

    void take(const CanFrame& frame) { m_drives.take(frame); }
    // Judges the replies, moves the set-points on and returns the frames to send: azimuth, elevation.
    [[nodiscard]] std::array<CanFrame, 2> tick();
    // The station has handed these frames to the link, or has no link now. A computer that is held up between the two
    // sends them late.
    void framesSent();

    // The end of the program: decelerate, then bring the drives into the profile's `on_exit` state. Keep ticking until
    // shutDownDone().
    void shutDown();
    [[nodiscard]] bool shutDownDone() const { return m_end.done(); }

    [[nodiscard]] StationState state() const { return report().state(); }
    // Everything this class knows; bus, clients and server are left to the Station.
    [[nodiscard]] StationStatus status() const { return report().status(); }
    // What the last tick commanded and what the drives have answered to it; empty before the first tick.
    [[nodiscard]] std::optional<TickSample> sample() const { return report().sample(); }
    // The mount still does what this source asked for last: nobody has ended it, nor asked for anything else.
    [[nodiscard]] bool obeys(const Source& source) const { return m_current.isFor(source) && moves(); }
    [[nodiscard]] bool followsClient() const { return m_current.commander().kind == SourceKind::Client && moves(); }
    // Another one each time that the mount is sent somewhere or given away; the operator's jogs and steps, Hold and
    // STOP leave it.
    [[nodiscard]] std::uint64_t errand() const { return m_current.errand(); }
    // Which turn the axis is on is told by the operator, or was: it may be another than before.
    [[nodiscard]] bool isTurnAsked(Axis axis) const { return m_turns.asked(axis); }
    [[nodiscard]] Authority authority() const { return m_arming.authority(); }
    // Whether this source may send the mount anywhere now; the error says what stands in the way.
    [[nodiscard]] Result<> mayPoint(const Source& source) const { return gates().mayPoint(source); }
    // Whether this source has the control, as far as the operator and the other clients are concerned.
    [[nodiscard]] Result<> mayCommand(const Source& source) const { return gates().mayCommand(source); }
    // Another client re-armed the drives; this one kept sending and has to act before it moves the mount.
    [[nodiscard]] bool waitsSinceRearm(const Source& client) const { return m_lead.waits(client.clientId); }
    // Whether the beam can be pointed there from where it is, by all that is permitted.
    [[nodiscard]] Result<> reaches(const SkyPointing& direction) const;
    [[nodiscard]] const pointing::PermittedRegion& region() const { return m_motion.region(); }
    // Whether other terms of the pointing model would leave the motion what it is.
    [[nodiscard]] Result<> mayChangePointing() const { return gates().mayChangePointing(); }
    // What a client may do now, into its part of the status; `lastMotion` is when it last asked for a motion.
    void describe(ClientStatus& client, const std::optional<SteadyTime>& lastMotion) const;
    // The axes as measured; an error when unknown or older than 1 s.
    [[nodiscard]] Result<AxisPosition> measured() const;
    // Where the beam points, while that is known and measured within the last second.
    [[nodiscard]] std::optional<SkyPointing> direction() const;
    // What is added to the targets of the client that is followed now: it is told positions without it.
    [[nodiscard]] std::optional<AxisPosition> trimInUse() const;
    // What the operator adds to whatever is followed.
    [[nodiscard]] const AxisPosition& trim() const { return m_motion.trim(); }
    // Both axes are this near to where they are sent.
    [[nodiscard]] bool onTarget(Angle within) const { return report().onTarget(within); }
    // Why not the target is driven but the nearest permitted place; empty: it is driven.
    [[nodiscard]] QString limitedReason() const { return report().limitedReason(); }
    [[nodiscard]] AlarmBoard& alarms() { return m_alarms; }
    // A drive was lost and nobody has re-armed yet; also while DISCONNECTED hides the word FAULT.
    [[nodiscard]] bool faultLatched() const { return m_arming.fault().has_value(); }

    // Whether the drives are fit to move the mount, by the survey of their protections. Nothing moves before.
    void setFitness(const Result<>& fitness) { m_arming.setFitness(fitness); }
    // What applies at once of a changed profile: in force from the next tick on, also for what moves.
    void setProfile(const profile::Profile& profile);
    // What the survey knows about a drive now; empty: nothing, its turn is then judged anew.
    void learn(Axis axis, const std::optional<survey::DriveFacts>& facts) { m_turnWatch.learn(axis, facts); }
    // Of the drive that was read there, empty if it told none; nothing: none was read.
    [[nodiscard]] std::optional<QString> uuid(Axis axis) const
    {
        return facts(axis) ? std::optional(facts(axis)->uuid) : std::nullopt;
    }
    // Where a sensor on the antenna says that the beam points: it speaks when a turn is asked for, and nowhere else.
    void setSensor(const std::optional<Angle>& azimuth, const std::optional<Angle>& elevation,
                   const std::optional<memory::SensorCourse>& course = std::nullopt);
    // What its position counts from is to be read anew.
    [[nodiscard]] bool needsOrigin(Axis axis) const { return m_turnWatch.needsOrigin(axis); }
    // The drive was power-cycled under our eyes.
    void driveRestarted(Axis axis);
    // What to do about a bus that is silent although it works: depends on what carries it.
    void setSilenceAdvice(const QString& advice);
    [[nodiscard]] bool answering(Axis axis) const
    {
        return m_drives.drive(axis).answering(m_now) && !m_arming.released();
    }
    [[nodiscard]] bool busReleased() const { return m_arming.released(); }
    [[nodiscard]] const memory::MountMemory& memory() const { return m_turns.memory(); }
    [[nodiscard]] bool takeMemoryChange() { return m_turns.takeChange(); }

private:
    Result<> handle(const request::PointSky& wanted, const Source& source);
    Result<> handle(const request::PointAxes& wanted, const Source& source);
    Result<> handle(const request::Jog& wanted, const Source& source);
    Result<> handle(const request::Move& wanted, const Source& source);
    Result<> handle(const request::Step& wanted, const Source& source);
    Result<> handle(const request::Follow& wanted, const Source& source);
    Result<> handle(const request::Hold& wanted, const Source& source);
    Result<> handle(const request::Stop& wanted, const Source& source);
    Result<> handle(const request::ResetStop& wanted, const Source& source);
    Result<> handle(const request::Park& wanted, const Source& source);
    Result<> handle(const request::Home& wanted, const Source& source);
    Result<> handle(const request::Unwind& wanted, const Source& source);
    Result<> handle(const request::Horizon& wanted, const Source& source);
    Result<> handle(const request::Rearm& wanted, const Source& source);
    Result<> handle(const request::TakeAuthority& wanted, const Source& source);
    Result<> handle(const request::GiveAuthority& wanted, const Source& source);
    Result<> handle(const request::GiveLead& wanted, const Source& source);
    Result<> handle(const request::SetReadOnly& wanted, const Source& source);
    Result<> handle(const request::Disconnect& wanted, const Source& source);
    Result<> handle(const request::AcknowledgeAlarms& wanted, const Source& source);
    Result<> handle(const request::ReadDrives& wanted, const Source& source);
    Result<> handle(const request::FixDrives& wanted, const Source& source);
    Result<> handle(const request::SwitchOff& wanted, const Source& source);
    Result<> handle(const request::ReleaseBus& wanted, const Source& source);
    Result<> handle(const request::TakeBus& wanted, const Source& source);
    Result<> handle(const request::ChooseTurn& wanted, const Source& source);
    Result<> handle(const request::ProveCrashStop& wanted, const Source& source);
    Result<> handle(const request::EndProof& wanted, const Source& source);
    Result<> handle(const request::Nudge& wanted, const Source& source);
    Result<> handle(const request::ClearTrim& wanted, const Source& source);
    Result<> handle(const request::AcknowledgeAlarm& wanted, const Source& source);
    Result<> handle(const request::ApplyProfile& wanted, const Source& source);
    Result<> handle(const request::Reconnect& wanted, const Source& source);
    Result<> handle(const CalibrationRequest& wanted, const Source& source);

    [[nodiscard]] ControlParts parts() const;
    [[nodiscard]] QString leadObstacle(const ClientStatus& client) const;
    [[nodiscard]] StatusReport report() const { return StatusReport(parts()); }
    [[nodiscard]] Gates gates() const { return Gates(parts()); }
    [[nodiscard]] bool moves() const { return m_current.moves(); }
    [[nodiscard]] bool turnsKnown() const { return m_turnWatch.allKnown(); }
    Result<> goTo(const AxisPosition& place, Activity activity, const Source& source, const QString& text);
    [[nodiscard]] Result<> mayGoTo(const AxisPosition& place) const;  // it is permitted, and there is a way
    [[nodiscard]] AxisPosition turnWithAWay(const AxisPosition& place) const;
    Result<> streamTo(pointing::Resolved resolved, const SkyPointing& asked, const Source& source,
                      const QString& what = {});
    Result<> runAt(const AxisRates& rates, Activity activity, const Source& source, const QString& text);
    void enforceRegion();
    void tellAdvice();
    [[nodiscard]] QString directionText(const AxisPosition& place) const;
    [[nodiscard]] Result<> mayMoveFirst(const AxisRates& rates);
    void watchFirstMoves();
    void setTrim(const AxisPosition& trim, const Source& source);
    void takeOver(const Source& source);
    void endClientMotion();
    void endCalibrationMotion();
    // Into the log; what clients can cause at will is throttled.
    void tell(Severity severity, const Source& source, const QString& what, LogKind kind = LogKind::Event);
    void begin(Activity activity, const Source& source, const QString& text);
    void holdHere(Activity activity);
    [[nodiscard]] AxisPosition standing() const { return parts().standing(); }
    [[nodiscard]] AxisPosition heading() const { return parts().heading(); }

    [[nodiscard]] AxisPosition heldPlace() const;
    void resumeAfterStall();
    void watchDrives();
    void keepStopped();
    void stopFor(Axis axis, const DriveWatch::Trouble& trouble);
    void keepTurns();
    void letBackInside();
    void watchJog();
    void watchFitness();
    void watchRegion();
    void renewSun(bool redrawn);
    void watchSun();
    void watchCable();
    void watchLimited();
    [[nodiscard]] std::optional<CableGuard::TurnBack> turnBackTo(const AxisPosition& place, const Source& source) const;
    void beginTurnBack(const std::optional<CableGuard::TurnBack>& back);
    void finishRearm();
    void moveOn(Seconds step);

    [[nodiscard]] DriveWatch& watchOf(Axis axis) { return m_watches[index(axis)]; }
    [[nodiscard]] const std::optional<survey::DriveFacts>& facts(Axis axis) const { return m_turnWatch.facts(axis); }

    profile::Profile m_profile;
    const Clock& m_clock;
    EventLog& m_log;
    pointing::MountModel m_model;
    DrivePair m_drives;
    Motion m_motion;
    SunWatch m_sun;
    Arming m_arming;
    ClientLead m_lead;
    AlarmBoard m_alarms;
    SunAlarms m_sunAlarms;
    std::array<DriveWatch, 2> m_watches;
    TurnKeeper m_turns;
    TurnWatch m_turnWatch;
    StallGuard m_stall;
    ProofRun m_proof;
    CableGuard m_cable;
    LogThrottle m_clientLines;

    CurrentMotion m_current;
    std::string m_heldAt;  // what the log last said the motion is held at
    FirstMoves m_firstMoves;
    std::vector<profile::Advice> m_advice;  // on the profile, as it was told
    std::array<bool, 2> m_ignoringBounds{};
    OrderlyEnd m_end;
    SteadyTime m_started{};  // the program, or the use of a bus that was taken back
    SteadyTime m_now{};      // of the running or last tick
    std::uint64_t m_tick = 0;
};

}  // namespace boresight
