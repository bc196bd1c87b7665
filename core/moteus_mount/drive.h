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

// One moteus controller as the station uses it: turns what the axis shall do into the one frame of this tick (command
// and query together) and replies into a report. Knows the drive's rules: a hold at the measured position comes before
// any set-point, a drive in fault or time-out is never commanded before it has shown mode 0, and every motion frame
// carries the watchdog time. A drive that no longer answers may still receive, so it is commanded to brake. Pure: time
// is passed in. Units are the drive's: output turns, Nm, A, V, °C. More than 15 members and
// 600 lines: one state machine, whose phases use most of them.
namespace boresight {

// The last reply, and when it came.
struct DriveReport
{
    SteadyTime received{};
    moteus::Mode mode = moteus::Mode::Stopped;
    int fault = 0;  // a fault in mode 1, an active limit (96…105) else
    moteus::HomeState homeState = moteus::HomeState::Relative;
    // As the reply says, true or not: motion uses Drive::place(). Empty if the drive does not know it: no encoder, not
    // calibrated.
    std::optional<MotorTurns> position;
    // Each is empty if the reply does not contain it, or contains no number.
    std::optional<MotorRate> rate;
    std::optional<double> torque;
    std::optional<double> current;   // q axis
    std::optional<double> dCurrent;  // spent on nothing but heat: the drive brakes by it
    std::optional<double> power;     // negative while it feeds the supply
    std::optional<double> voltage;
    std::optional<double> boardTemperature;
    std::optional<double> motorTemperature;  // also without a sensor
};

// Frames sent before the running tick, and how many of them were answered before the next frame went out.
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
    MotorRate velocityLimit;  // above the host's own limits: the host limits, the drive guards
    MotorAcceleration accelerationLimit;
    MotorAcceleration emergencyBraking;  // of "hold where you are"
    supervision::PlaceBelief::Limits places{};
};

// Why a drive can not be commanded any more. All but a fault arise only while it is under orders.
enum class DriveLoss
{
    Silent,    // no reply for kSilence
    Fault,     // mode 1, in any phase
    TimedOut,  // mode 11: its own watchdog stopped it
    Released,  // another mode without our command: power cycle, or another program
    Disobeys,  // answers, but does not follow its commands for kObedience
    Blind,     // answers, but no place that can be believed for kSilence
};

class Drive
{
public:
    enum class Phase
    {
        Listening,    // only queries are sent
        Capturing,    // "brake and hold" is sent until the drive reports position mode and stands
        Engaged,      // set-points are sent
        Unseen,       // was Engaged, and no longer answers or reports its position: "brake and hold" is sent
        Held,         // its place has jumped, so that no set-point means anything: "brake and hold" until engage()
        Recovering,   // stop is sent until the drive reports mode 0; from a time-out it is captured again at once
        Referencing,  // the drive receives its wrap. An axis that was held is held meanwhile
        Starving,     // under orders, but only asked: its watchdog shall stop it, and that is watched
        Braking,      // phases shorted, for the end of the program
        Releasing,    // stop is sent until the drive reports mode 0, then it is only listened to
    };

    static constexpr int kMostUnanswered = 2;  // frames in a row that may be lost, as for the watchdog
    // Within 0.3 s on the screen: a tick, an update of the window (0.05 s) and a frame later.
    static constexpr std::chrono::milliseconds kSilence{200};
    static constexpr std::chrono::milliseconds kObedience{1000};  // enabling takes a drive some 13 ms

    Drive(const DriveSettings& settings, std::string name);
    // From the next frame on; the same id. A drive knows no axis and no profile, but its own units.
    void setSettings(const DriveSettings& settings);

    // Orders of the station; they take effect in the next frame.
    void engage();  // Listening -> (Recovering, after a time-out ->) Capturing -> Engaged
    void seize();   // engage, but only a drive that does something without our orders
    void listen();  // stop commanding; the drive's watchdog then ends what it did
    // Clears a fault or time-out. A drive that held an axis by its time-out mode is captured again, so that an
    // unbalanced axis falls only until mode 0 was seen (two ticks) and for the 13 ms of enabling; after a fault it is
    // left off.
    void recover();
    // Sets the position of a drive that canBeReferenced() to `place`. It keeps the phase of its encoder and takes the
    // nearest turn; without any reference (home state 0) it takes the place as it is. Done when it reports the place
    // within `tolerance`. A drive that is Engaged holds meanwhile and is captured again.
    void reference(MotorTurns place, MotorTurns tolerance);
    [[nodiscard]] bool canBeReferenced() const;
    void hold();  // Engaged, Unseen, Capturing -> Held; not commanded: stays so
    // Engaged -> Capturing, for an axis that something blocks: the drive's control restarts where the axis is, and what
    // its integrator has wound up is dropped. That stays out until the set-point moves again: against an obstacle it
    // would wind up again by the last digit of the position. The rest of the control holds the axis meanwhile.
    void yield();
    void starve();  // Engaged -> Starving
    void brake();
    void release();
    // For an axis known to stand beyond the drive's own position bounds: they would refuse the way back (fault 39).
    void setIgnoreBounds(bool ignore) { m_ignoreBounds = ignore; }
    // Sent while Engaged, in the tick for which it was set. In a tick without one the drive goes to the last one.
    void setSetpoint(const MotorSetpoint& setpoint);
    // The set-points brake as hard as "hold where you are": the drive must not be the slower one.
    void setHardBraking(bool hard) { m_hardBraking = hard; }

    // Takes a frame from the bus; false if it is not a reply of this drive to us.
    bool take(const CanFrame& frame);

    void frameSent() { m_replyDue = true; }     // the link has taken the frame()
    void restartCount() { m_replyCount = {}; }  // the link was opened
    [[nodiscard]] const ReplyCount& replyCount() const { return m_replyCount; }

    // Once per tick: draws the conclusions from the replies (see takeLoss() and takeEngaged()), then the frame to send.
    void judge(SteadyTime now);
    [[nodiscard]] CanFrame frame() const;
    // We did not look at the bus for so long: this does not count as silence or disobedience of the drive.
    void excuse(Seconds stall, SteadyTime now);
    void expectAnotherPlace() { m_belief.expectAnother(); }  // how it moved meanwhile is not known

    // True once after the drive has become Engaged: the first set-point must be at its place(), which is of this tick.
    [[nodiscard]] bool takeEngaged() { return std::exchange(m_justEngaged, false); }
    // Given once when a drive was lost, or is in fault; it is Listening then.
    [[nodiscard]] std::optional<DriveLoss> takeLoss() { return std::exchange(m_loss, std::nullopt); }
    [[nodiscard]] const std::optional<DriveLoss>& loss() const { return m_loss; }  // not taken yet

    [[nodiscard]] Phase phase() const { return m_phase; }
    [[nodiscard]] const std::string& name() const { return m_name; }  // as the source of a line and cause of an alarm
    [[nodiscard]] QString label() const { return Text::of(m_name); }  // as it stands in a sentence
    [[nodiscard]] const std::optional<DriveReport>& report() const { return m_report; }
    // Where it stands: the last place that is believed, and when it came. See PlaceBelief.
    [[nodiscard]] const std::optional<supervision::PlaceBelief::Place>& place() const { return m_belief.place(); }
    // What was reported and was false, or has turned out to be a jump: each is given once.
    [[nodiscard]] std::optional<supervision::PlaceBelief::Leap> takeFalsePlace() { return m_belief.takeFalsePlace(); }
    [[nodiscard]] std::optional<supervision::PlaceBelief::Leap> takeJump() { return m_belief.takeJump(); }
    [[nodiscard]] bool jumped() const { return m_belief.jumped(); }  // and nobody has taken it
    // It was away, or was restarted: where it stands now is no jump.
    void forgetPlace() { m_belief.forget(); }
    [[nodiscard]] bool answering(SteadyTime now) const;
    [[nodiscard]] SteadyTime heard() const { return m_heard; }  // the last reply, stalls of our own excused
    // More frames in a row were not answered with a place that is believed than can be lost by chance: nobody sees what
    // the drive does. Counted in frames, so that a late tick of ours is no silence of the drive.
    [[nodiscard]] bool unseen() const { return m_unanswered > kMostUnanswered; }
    // In fault or time-out: takes no command but stop.
    [[nodiscard]] bool latched() const;
    // Moves or holds the axis although we did not order it: another program, or an order without a watchdog.
    [[nodiscard]] bool activeUnordered() const;
    // True once after the drive has taken the place of reference().
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
    bool m_onlyHold = false;  // once captured
    bool m_justEngaged = false;
    bool m_justReferenced = false;
    bool m_heldWhenReferenced = false;
    bool m_holdNext = false;  // while Referencing: every second frame
    bool m_ignoreBounds = false;
    bool m_yielding = false;  // without the integrator
    bool m_hardBraking = false;
    bool m_faultTold = false;
    SteadyTime m_heard{};     // last reply, stalls of our own excused
    SteadyTime m_placed{};    // last believed place, stalls of our own excused
    bool m_replied = false;   // since the last tick
    bool m_replyDue = false;  // a frame was sent since the last tick
    ReplyCount m_replyCount;
    bool m_saidPlace = false;             // since the last tick, one that is believed
    std::optional<SteadyTime> m_asked{};  // the oldest frame without a reply, else the last one
    int m_unanswered = 0;                 // frames in a row
    int m_repliesInPhase = 0;
    std::optional<SteadyTime> m_phaseSince;  // of all but Listening and Braking
    int m_stallsInPhase = 0;                 // our own
    MotorSetpoint m_setpoint;
    RateFollower m_follower;
    std::optional<MotionOrder> m_order;  // of this tick
    SteadyTime m_tick{};                 // when it began
    int m_tickNumber = 0;                // modulo kEchoes, and so in its frame
    MotorTurns m_reference;
    MotorTurns m_referenceTolerance;
    std::optional<DriveReport> m_report;
    supervision::PlaceBelief m_belief;
    std::optional<DriveLoss> m_loss;
};

}  // namespace boresight
