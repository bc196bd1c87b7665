// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/result.h"
#include "core/base/text.h"
#include "core/moteus/codec.h"
#include "core/moteus_mount/rate_follower.h"
#include "core/supervision/place_belief.h"
#include "core/units/quantity.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

// One moteus controller as the station uses it. Turns the order for the axis into one frame per tick (command and query
// together), and turns each reply into a report. Follows the rules of the drive:
// - A hold at the measured position comes before any set-point.
// - A drive in fault or time-out is not commanded before it has reported mode 0.
// - Every motion frame carries the watchdog time.
// - A drive that does not answer may still receive frames, so it is commanded to brake.
// Pure: time is passed in. Units are those of the drive: output turns, Nm, A, V, °C. It has more than 15 members and
// 600 lines because it is one state machine, whose phases use most of the members.
namespace boresight {

// The last reply, and when it was received.
struct DriveReport
{
    SteadyTime received{};
    moteus::Mode mode = moteus::Mode::Stopped;
    int fault = 0;  // mode 1: the fault. Other modes: an active limit (96…105), or 0
    moteus::HomeState homeState = moteus::HomeState::Relative;
    // As the reply contains it, even if it is false. Motion uses Drive::place(). Empty if the drive does not know its
    // position: it has no encoder or is not calibrated.
    std::optional<MotorTurns> position;
    // Each of these is empty if the reply does not contain it, or contains no number.
    std::optional<MotorRate> rate;
    std::optional<double> torque;
    std::optional<double> current;   // q axis
    std::optional<double> dCurrent;  // makes only heat: the drive brakes with it
    std::optional<double> power;     // negative while the drive feeds the supply
    std::optional<double> voltage;
    std::optional<double> boardTemperature;
    std::optional<double> motorTemperature;  // empty also if there is no sensor
};

// The number of frames sent before the current tick, and how many of them were answered before the next frame was sent.
struct ReplyCount
{
    std::uint64_t sent = 0;
    std::uint64_t answered = 0;
};

struct DriveSettings
{
    int id = 1;
    Seconds watchdog{0.1};
    double maxTorque = 0.0;
    Seconds tick{0.02};
    MotorRate speed;          // of the axis
    MotorRate velocityLimit;  // larger than the limits of the host: the host limits the motion, the drive only guards
    MotorAcceleration accelerationLimit;
    MotorAcceleration emergencyBraking;  // for "brake and hold"
    supervision::PlaceBelief::Limits places{};
};

// Why a drive can no longer be commanded. All reasons but Fault arise only while the drive is under our commands.
enum class DriveLoss
{
    Silent,    // no reply for kSilence
    Fault,     // mode 1, in any phase
    TimedOut,  // mode 11: its own watchdog stopped it
    Released,  // another mode without our command: a power cycle, or another program
    Disobeys,  // answers, but does not follow its commands for kObedience
    Blind,     // answers, but has reported no believable position for kSilence
};

class Drive
{
public:
    enum class Phase
    {
        Listening,    // only queries are sent
        Capturing,    // "brake and hold" is sent until the drive reports position mode and stands still
        Engaged,      // set-points are sent
        Unseen,       // was Engaged, but does not answer or does not report its position: "brake and hold" is sent
        Held,         // the reported position has jumped, so set-points mean nothing: "brake and hold" until engage()
        Recovering,   // stop is sent until the drive reports mode 0. After a time-out, Capturing follows at once
        Referencing,  // the drive receives its wrap. If the axis was held before, it is held meanwhile
        Starving,     // only queries are sent to a moving drive: its watchdog stops it, which is measured
        Braking,      // motor phases shorted, at the end of the program
        Releasing,    // stop is sent until the drive reports mode 0, then only queries are sent
    };

    static constexpr int kMostUnanswered = 2;  // frames in a row that may be lost, as the watchdog time allows
    // The silence must be on the screen within 0.3 s: this time, a tick, an update of the window (0.05 s) and a frame.
    static constexpr std::chrono::milliseconds kSilence{200};
    static constexpr std::chrono::milliseconds kObedience{1000};  // a drive takes 13 ms to enable its motor

    Drive(const DriveSettings& settings, std::string name);
    // Valid from the next frame on. The id must stay the same. A drive knows no axis and no profile, only its own
    // units.
    void setSettings(const DriveSettings& settings);

    // Orders of the station; they take effect in the next frame.
    void engage();  // Listening -> (Recovering, after a time-out ->) Capturing -> Engaged
    void seize();   // engage(), but only for a drive that is active without our commands
    void listen();  // stop commanding. The watchdog of the drive then ends its motion
    // Clears a fault or time-out. If the time-out mode of the drive held the axis, the drive is captured again. An
    // unbalanced axis then falls only until mode 0 is reported (two ticks) and for the 13 ms of enabling. After a fault
    // the drive stays off.
    void recover();
    // Sets the position of a drive that canBeReferenced() to `place`. The drive keeps the phase of its encoder and uses
    // the nearest turn. Without any reference (home state 0) it uses `place` as it is. The work is done when the drive
    // reports a position within `tolerance` of `place`. A drive that is Engaged holds meanwhile and is captured again.
    void reference(MotorTurns place, MotorTurns tolerance);
    [[nodiscard]] bool canBeReferenced() const;
    void hold();  // Engaged, Unseen, Capturing -> Held. No effect in other phases
    // Engaged -> Capturing, for an axis that something blocks. The control of the drive restarts where the axis is,
    // which clears its integrator. The integrator stays off until the set-point moves again. Otherwise an error of one
    // position step would wind it up against the obstacle. Meanwhile the rest of the control holds the axis.
    void yield();
    void starve();  // Engaged -> Starving
    void brake();
    void release();
    // For an axis that is known to be beyond the position bounds of the drive. With the bounds in force the drive would
    // refuse the way back (fault 39).
    void setIgnoreBounds(bool ignore) { m_ignoreBounds = ignore; }
    // Sent while Engaged, in the tick for which it was set. In a tick without a new set-point the drive goes to the
    // last one.
    void setSetpoint(const MotorSetpoint& setpoint);
    // The set-points brake as hard as "brake and hold" does. The acceleration limit of the drive must not be lower than
    // that.
    void setHardBraking(bool hard) { m_hardBraking = hard; }

    // Reads a frame from the bus. False if it is not a reply of this drive to us.
    bool take(const CanFrame& frame);

    void frameSent() { m_replyDue = true; }     // the link has accepted the frame()
    void restartCount() { m_replyCount = {}; }  // the link was opened
    [[nodiscard]] const ReplyCount& replyCount() const { return m_replyCount; }

    // Once per tick, before frame(): evaluates the replies. The results are takeLoss() and takeEngaged().
    void judge(SteadyTime now);
    [[nodiscard]] CanFrame frame() const;
    // For the time `stall` this computer did not read the bus. That time does not count as silence or disobedience.
    void excuse(Seconds stall, SteadyTime now);
    void expectAnotherPlace() { m_belief.expectAnother(); }  // the drive may have moved unseen

    // True once after the drive has become Engaged. The first set-point must be at place(), which is of this tick.
    [[nodiscard]] bool takeEngaged() { return std::exchange(m_justEngaged, false); }
    // The reason, once, after a drive was lost or went into fault. The drive is then Listening.
    [[nodiscard]] std::optional<DriveLoss> takeLoss() { return std::exchange(m_loss, std::nullopt); }
    [[nodiscard]] const std::optional<DriveLoss>& loss() const { return m_loss; }  // not yet taken by takeLoss()

    [[nodiscard]] Phase phase() const { return m_phase; }
    [[nodiscard]] const std::string& name() const { return m_name; }  // for log lines and alarms
    [[nodiscard]] QString label() const { return Text::of(m_name); }  // translated, for use in a sentence
    [[nodiscard]] const std::optional<DriveReport>& report() const { return m_report; }
    // The last position that is believed, and when it was received. See PlaceBelief.
    [[nodiscard]] const std::optional<supervision::PlaceBelief::Place>& place() const { return m_belief.place(); }
    // A reported position that was false, and one that proved to be a jump. Each is returned once.
    [[nodiscard]] std::optional<supervision::PlaceBelief::Leap> takeFalsePlace() { return m_belief.takeFalsePlace(); }
    [[nodiscard]] std::optional<supervision::PlaceBelief::Leap> takeJump() { return m_belief.takeJump(); }
    [[nodiscard]] bool jumped() const { return m_belief.jumped(); }  // and takeJump() was not called yet
    // The drive was away or was restarted, so another position is no jump.
    void forgetPlace() { m_belief.forget(); }
    [[nodiscard]] bool answering(SteadyTime now) const;
    [[nodiscard]] SteadyTime heard() const { return m_heard; }  // the last reply; stalls of this computer are excused
    // More frames in a row than can be lost by chance got no reply with a believable position, so nobody sees what the
    // drive does. Frames are counted, not time, so that a late tick of ours is no silence of the drive.
    [[nodiscard]] bool unseen() const { return m_unanswered > kMostUnanswered; }
    // In fault or time-out: the drive accepts no command but stop.
    [[nodiscard]] bool latched() const;
    // Moves or holds the axis without our command: another program commands it, or it has an order without a watchdog.
    [[nodiscard]] bool activeUnordered() const;
    // True once after the drive has accepted the position of reference().
    [[nodiscard]] bool takeReferenced() { return std::exchange(m_justReferenced, false); }

private:
    void enter(Phase phase);
    void takePlace();
    void takeControl(const moteus::Reply& reply);
    [[nodiscard]] std::optional<int> ticksAgo(const moteus::Reply& reply) const;
    void countReply();
    void lose(DriveLoss loss);
    void judgeFault();
    void judgePhase(moteus::Mode mode, Seconds inPhase);
    void judgeCapture(Seconds inPhase);
    void judgeReference();
    [[nodiscard]] bool mustObey() const;
    [[nodiscard]] std::optional<moteus::Command> command() const;
    [[nodiscard]] moteus::Command referenceCommand() const;
    [[nodiscard]] moteus::PositionCommand positionCommand(const MotionOrder& order) const;
    [[nodiscard]] MotorAcceleration hardest() const
    {
        return m_hardBraking ? m_settings.emergencyBraking : m_settings.accelerationLimit;
    }
    [[nodiscard]] moteus::PositionCommand holdCommand() const;

    DriveSettings m_settings;
    std::string m_name;
    Phase m_phase = Phase::Listening;
    bool m_captureAfterRecovery = false;
    bool m_onlyHold = false;  // once captured, go to Held
    bool m_justEngaged = false;
    bool m_justReferenced = false;
    bool m_heldWhenReferenced = false;
    bool m_holdNext = false;  // while Referencing: true in every second frame
    bool m_ignoreBounds = false;
    bool m_yielding = false;  // the integrator is off
    bool m_hardBraking = false;
    bool m_faultTold = false;
    SteadyTime m_heard{};     // last reply; stalls of this computer are excused
    SteadyTime m_placed{};    // last believed position; stalls of this computer are excused
    bool m_replied = false;   // since the last tick began
    bool m_replyDue = false;  // a frame was sent since the last tick began
    ReplyCount m_replyCount;
    bool m_saidPlace = false;             // a believed position was received since the last tick began
    std::optional<SteadyTime> m_asked{};  // send time of the oldest frame without a reply, else of the last one
    int m_unanswered = 0;                 // frames in a row
    int m_repliesInPhase = 0;
    std::optional<SteadyTime> m_phaseSince;  // empty in Listening and Braking
    int m_stallsInPhase = 0;                 // stalls of this computer
    MotorSetpoint m_setpoint;
    RateFollower m_follower;
    std::optional<MotionOrder> m_order;  // of the current tick
    SteadyTime m_tick{};                 // when it began
    int m_tickNumber = 0;                // modulo kEchoes; each frame carries the number
    MotorTurns m_reference;
    MotorTurns m_referenceTolerance;
    std::optional<DriveReport> m_report;
    supervision::PlaceBelief m_belief;
    std::optional<DriveLoss> m_loss;
};

}  // namespace boresight
