// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/drive_check/drive_check.h"
#include "core/journal/course_anchor.h"
#include "core/journal/mount_journal.h"
#include "core/journal/reconcile.h"
#include "core/messages/turn_question.h"
#include "core/moteus_mount/drive_pair.h"
#include "core/profile/in_force.h"

#include <array>
#include <optional>

// Decides whether the wrap of each axis is known, and keeps the position journal that proves it later. The wrap of a
// drive that was silent or restarted is judged again, from the journal, the home state and the reported position. If
// only the operator can know the wrap, the operator is asked. The answer is written into the drive, so that its own
// bounds guard the right angles. Until then the drive counts from the middle of the travel, where its bounds leave room
// on both sides. Asks the kernel how far the clocks of this computer can be trusted, otherwise pure. Mechanical angles.
namespace boresight {

class TurnKeeper
{
public:
    struct Start
    {
        journal::MountJournal journal;
        QString problem;  // why there is no journal, or only an old one: "the journal file is missing"
        // True for the simulated mount: the first reported position is the right one.
        bool trustFirstContact = false;
        // Where the axes are, as the operator entered at the start of the program, within 20°. Answers the first
        // question about each axis and no later one, if it is not older than kPlaceAge and was never used before.
        std::array<std::optional<Angle>, 2> standingAt{};
        UtcTime looked{};  // when the operator looked at the mount
    };
    // Long enough to look at the mount, to walk to the computer and to start the program.
    static constexpr std::chrono::minutes kPlaceAge{10};

    TurnKeeper(const profile::InForce& profile, const Clock& clock, EventLog& log, Start start);

    // The drive was silent, restarted or lost count, so its wrap must be judged again. `doubt`: why the journal must
    // not prove the wrap. Empty if it may.
    void forget(Axis axis, const std::optional<QString>& doubt = std::nullopt);
    // Judges the wrap from what is known about the drive, and writes the answer into the drive. Call each tick.
    void judge(Axis axis, const drive_check::DriveFacts& facts, Drive& drive, SteadyTime now);
    // Success if the operator is being asked about the axis and its drive can accept an answer now.
    [[nodiscard]] Result<> mayChoose(Axis axis, const Drive& drive) const;
    // The operator has looked: the axis is near `angle`. Refused if the direction that the drive reports contradicts
    // this.
    Result<> choose(Axis axis, Angle angle, Drive& drive, const QString& source);

    // The mechanical direction that a sensor on the antenna measures now. It is shown as evidence with the question.
    void setSensor(Axis axis, const std::optional<Angle>& heading) { m_sensor[index(axis)] = heading; }

    // How far the sensor saw the azimuth turn. It is compared with where the axis was while its wrap was known.
    void setCourse(const std::optional<SensorCourse>& course) { m_course = course; }

    [[nodiscard]] bool known(Axis axis) const { return state(axis).phase == Phase::Known; }
    // The wrap is known only from what the operator entered, and on another one the end of the cable would be near.
    [[nodiscard]] bool entered(Axis axis) const { return known(axis) && state(axis).entered && state(axis).nearEnd; }
    [[nodiscard]] bool asked(Axis axis) const { return state(axis).phase == Phase::Asked; }
    // Why the position entered at the start of the program was not used. Empty if it was used or none was entered.
    [[nodiscard]] const QString& placeProblem(Axis axis) const { return m_placeProblems[index(axis)]; }
    // The question that waits for the operator. Its candidates move along when the axis is jogged.
    [[nodiscard]] std::optional<TurnQuestion> question(Axis axis, const Drive& drive) const;

    // The origin of the drive's count must be read (again). Without it nothing can be proved. And a tool that sets the
    // position of a drive whose wrap is known changes the origin.
    [[nodiscard]] bool needsOrigin(Axis axis, const drive_check::DriveFacts& facts) const;
    // Records in the journal where an axis with a known wrap is.
    void note(Axis axis, const drive_check::DriveFacts& facts, const Drive& drive, bool moving, SteadyTime now);
    void keep(Axis axis, const CrashStop& stop);
    [[nodiscard]] const journal::MountJournal& journal() const { return m_start.journal; }
    // True once after the position journal changed and must be saved.
    [[nodiscard]] bool takeChange() { return std::exchange(m_changed, false); }

private:
    enum class Phase
    {
        Unjudged,
        Asked,
        Writing,  // into the drive
        Known,
    };
    struct State
    {
        Phase phase = Phase::Unjudged;
        std::optional<QString> doubt{};
        // Values that were read from the drive before this time are not valid any more: the drive was silent, or its
        // position was set.
        SteadyTime since = SteadyTime::min();
        TurnQuestion question{};
        MotorTurns reportedWhenAsked{};
        std::optional<SteadyTime> noted{};
        SteadyTime notBefore{};                                     // when the next judgement may be made
        moteus::HomeState homeState = moteus::HomeState::Relative;  // while the wrap is known
        std::optional<moteus::CountOrigin> origin{};                // while the wrap is known. Empty: not read yet
        drive_check::OriginReading other{};                         // the last reading, if it differs from `origin`
        // Where the axis was since the operator entered its wrap. Empty: the wrap is not in doubt.
        std::optional<TravelRange> entered{};
        bool nearEnd = false;  // on another wrap that is not excluded
    };

    [[nodiscard]] State& state(Axis axis) { return m_states[index(axis)]; }
    [[nodiscard]] const State& state(Axis axis) const { return m_states[index(axis)]; }
    [[nodiscard]] std::optional<journal::TurnRecord>& record(Axis axis);
    [[nodiscard]] journal::DriveFrame frame(Axis axis, const drive_check::DriveFacts& facts, const Drive& drive,
                                            SteadyTime now) const;
    [[nodiscard]] bool isFresh(Axis axis, const drive_check::DriveFacts& facts) const;
    [[nodiscard]] bool ofTheOtherAxis(Axis axis, const drive_check::DriveFacts& facts) const;
    void judgeAnew(Axis axis, const drive_check::DriveFacts& facts, Drive& drive, SteadyTime now);
    void ask(Axis axis, const TurnQuestion& question, const Drive& drive);
    [[nodiscard]] std::optional<Angle> takeEnteredPlace(Axis axis);
    [[nodiscard]] Result<> enteredPlaceCounts() const;
    [[nodiscard]] bool chooseAsEntered(Axis axis, Angle place, Drive& drive);
    void countFromTheMiddle(Axis axis, Drive& drive);
    void watchJog(Axis axis, const Drive& drive);
    void watchOrigin(Axis axis, const drive_check::DriveFacts& facts);
    void watchEntered(Axis axis, const Drive& drive);
    [[nodiscard]] bool isSameOrigin(Axis axis, const drive_check::DriveFacts& facts,
                                    const moteus::CountOrigin& one) const;
    [[nodiscard]] Angle period(Axis axis, const drive_check::DriveFacts& facts) const;
    void becomeKnown(Axis axis, const Drive& drive);
    void settle(Axis axis, Angle angle, Angle period, Drive& drive, const QString& source, const QString& why);
    [[nodiscard]] MotorTurns tolerance(Axis axis, Angle period) const;
    void addTurning(Axis axis, TurnQuestion& question) const;
    [[nodiscard]] Angle movedSince(Axis axis, const Drive& drive) const;

    const profile::InForce& m_profile;
    const Clock& m_clock;
    EventLog& m_log;
    Start m_start;
    bool m_placeUsedBefore;
    std::array<QString, 2> m_placeProblems;
    std::array<State, 2> m_states;
    std::array<std::optional<Angle>, 2> m_sensor;
    std::optional<SensorCourse> m_course;
    std::optional<journal::CourseAnchor> m_anchor;  // of the azimuth
    bool m_changed = false;
};

}  // namespace boresight
