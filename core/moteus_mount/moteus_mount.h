// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/base/can_frame.h"
#include "core/base/clock.h"
#include "core/moteus_mount/drive_pair.h"
#include "core/moteus_mount/drive_watch.h"
#include "core/moteus_mount/proof_run.h"
#include "core/moteus_mount/silence_alarms.h"
#include "core/moteus_mount/stall_guard.h"
#include "core/moteus_mount/third_drive.h"
#include "core/moteus_mount/turn_keeper.h"
#include "core/moteus_mount/turn_watch.h"
#include "core/mount/mount_driver.h"
#include "core/mount/mount_service.h"
#include "core/profile/in_force.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

// One or two moteus on a CAN bus as a MountDriver: frames in, frames out. Watches the drives, keeps their wraps and
// their position journal, excuses them for stalls of this computer, and runs the crash-stop test. The owner of the bus
// passes received frames in and sends those of frames(). DriveCare runs the drive check beside it. An axis without a
// moteus is not queried, commanded, watched or journalled. Station thread only. More than 15 members and
// 600 lines: the parts of all drives, and what one step of a tick leaves to the next.
namespace boresight {

class MoteusMount final : public MountDriver, public MountService
{
public:
    // The references outlive this object. `axes`: the axes that a moteus turns, at least one.
    MoteusMount(const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms,
                TurnKeeper::Start start = {}, AxisSet axes = kAxes);

    [[nodiscard]] AxisSet axes() const { return m_drives.axes(); }

    // For the owner of the bus.
    void take(const CanFrame& frame);
    [[nodiscard]] std::vector<CanFrame> frames() const;  // azimuth, elevation, third axis
    // These frames were passed to the link, or there is no link now. If this computer is held up after frames(), it
    // sends them late.
    void framesSent();
    void lineOpened();   // replies are counted from here on
    void framesTaken();  // by the link: a reply to each frame is due
    [[nodiscard]] bool busLeft() const { return m_busLeft; }
    // What to do about a bus that is silent although it works. The advice depends on the kind of the bus.
    void setSilenceAdvice(const QString& advice) { m_silences.setAdvice(advice); }

    // The result of the drive check.
    void setInterlock(const Result<>& interlock) { m_interlock = interlock; }
    void learn(Axis axis, const std::optional<drive_check::DriveFacts>& facts) { m_turnWatch.learn(axis, facts); }
    [[nodiscard]] bool needsOrigin(Axis axis) const { return m_turnWatch.needsOrigin(axis); }
    void driveRestarted(Axis axis);  // it was power-cycled while we watched it
    void countsAnew(Axis axis);      // its encoder counts from a new zero, after a change of its settings
    // The settings of the drive are being changed, so another position is no jump.
    void expectAnotherCount(Axis axis) { m_drives.drive(axis).forgetPlace(); }

    // The position journal.
    [[nodiscard]] const journal::MountJournal& journal() const { return m_turns.journal(); }
    [[nodiscard]] bool takeJournalChange() { return m_turns.takeChange(); }
    // How far a sensor on the antenna saw the azimuth turn.
    void setCourse(const std::optional<SensorCourse>& course) { m_turns.setCourse(course); }

    [[nodiscard]] Capabilities capabilities() const override;
    [[nodiscard]] const QString& name(Axis axis) const override { return m_names[index(axis)]; }
    [[nodiscard]] QString label(Axis axis) const override { return m_drives.drive(axis).label(); }
    [[nodiscard]] std::optional<QString> identity(Axis axis) const override;
    [[nodiscard]] QString lastIdentity(Axis axis) const override;
    [[nodiscard]] AxisReport report(Axis axis) const override;
    [[nodiscard]] Result<> available() const override;
    [[nodiscard]] const Result<>& interlock() const override { return m_interlock; }
    [[nodiscard]] MountService* service() override { return this; }
    [[nodiscard]] const MountService* service() const override { return this; }
    [[nodiscard]] ThirdAxis* thirdAxis() override { return m_third.isUsed() ? &m_third : nullptr; }
    [[nodiscard]] const ThirdAxis* thirdAxis() const override { return m_third.isUsed() ? &m_third : nullptr; }
    void observe(SteadyTime now) override;
    [[nodiscard]] MountFindings supervise(const MountSituation& known) override;
    void engage() override { m_drives.engage(); }
    [[nodiscard]] std::optional<Angle> takeFollowing(Axis axis) override;
    void command(Axis axis, const tracking::Setpoint& setpoint) override;
    void brakeHard(bool hard) override { m_drives.setHardBraking(hard); }
    void seize() override { m_drives.seize(m_now); }
    void recover() override;
    void rearmed() override;
    void leave(profile::OnExit how) override { m_drives.leave(how); }
    void setSensor(Axis axis, const std::optional<Angle>& heading) override { m_turns.setSensor(axis, heading); }

    void describe(DrivesStatus& status) const override;
    [[nodiscard]] Result<> mayBeWritten() const override;
    [[nodiscard]] Result<> mayBeTuned(Axis axis) const override;
    [[nodiscard]] Result<> maySwitchOff(Axis axis) const override;
    [[nodiscard]] QString switchOff(std::optional<Axis> only) override;
    [[nodiscard]] QString leaveBus() override;
    [[nodiscard]] Result<> mayTakeBus() const override;
    Result<> takeBus() override;
    [[nodiscard]] Result<> mayChooseWrap(Axis axis) const override;
    [[nodiscard]] Result<> chooseWrap(Axis axis, Angle angle, const QString& source) override;
    [[nodiscard]] Result<> mayProve(AngularRate rate, const TravelRange& azimuths,
                                    const TravelRange& elevations) override;
    void beginProof() override;
    [[nodiscard]] bool proofRunning() const override { return m_proof.running(); }
    [[nodiscard]] ProofStep stepProof() override { return m_proof.step(m_now, m_clock.utc()); }
    void endProof(const QString& how) override { m_proof.end(how); }

private:
    void keepTurns(const MountSituation& known, MountFindings& found);
    void resumeAfterStall(const MountSituation& known, MountFindings& found);
    void watchDrives(const MountSituation& known, MountFindings& found);
    void stopFor(Axis axis, const DriveWatch::Trouble& trouble, MountFindings& found);
    void interruptProof();
    void letBackInside();
    [[nodiscard]] bool has(Axis axis) const { return std::ranges::find(axes(), axis) != axes().end(); }
    [[nodiscard]] bool isFarOutside(Axis axis) const;
    [[nodiscard]] AxisPosition heldPlace() const;
    [[nodiscard]] AxisHand handOf(const Drive& drive, Axis axis) const;
    // The reports of the drives can be used: their gear and safety settings are right, or are still being read.
    [[nodiscard]] bool readable() const { return m_interlock || m_interlock.error().code == ErrorCode::Busy; }

    const profile::InForce& m_profile;
    const Clock& m_clock;
    EventLog& m_log;
    AlarmBoard& m_alarms;
    DrivePair m_drives;
    ThirdDrive m_third;
    std::array<QString, 2> m_names;
    SilenceAlarms m_silences;
    std::array<DriveWatch, 2> m_watches;
    TurnKeeper m_turns;
    TurnWatch m_turnWatch;
    StallGuard m_stall;
    ProofRun m_proof;
    std::optional<CrashStopProof> m_nextProof;
    Result<> m_interlock;
    std::array<tracking::Setpoint, 2> m_setpoints{};  // as last commanded
    std::array<bool, 2> m_ignoringBounds{};
    bool m_busLeft = false;
    bool m_restarted = false;  // a drive restarted since the last supervise()
    bool m_observed = false;
    SteadyTime m_started;  // start of the program, or of the use of a bus that was taken back
    SteadyTime m_now;      // of the current or last tick
};

}  // namespace boresight
