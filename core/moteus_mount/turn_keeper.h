// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/memory/course_anchor.h"
#include "core/memory/mount_memory.h"
#include "core/memory/reconcile.h"
#include "core/messages/turn_question.h"
#include "core/moteus_mount/drive_pair.h"
#include "core/profile/in_force.h"
#include "core/survey/drive_survey.h"

#include <array>
#include <optional>

// Knows whether the turn of each axis is known, and keeps the journal that proves it later. A drive that was silent or
// restarted is judged again from journal, home state and reported position; what only the operator can tell becomes a
// question. The answer is written into the drive, so that its own bounds guard the right place; until then it counts
// from the middle of the travel, where its bounds leave room on both sides. Asks the kernel what this computer's clocks
// are worth; else pure. Mechanical angles.
namespace boresight {

class TurnKeeper
{
public:
    struct Start
    {
        memory::MountMemory memory;
        QString problem;  // why there is no journal, or not the newest: "the journal file is missing"
        // The built-in simulated mount starts where its drives report.
        bool trustFirstContact = false;
        // Where the operator entered at the start of the program that the mount stands, about. Answers the first
        // question about each axis, and no later one, while it is not older than kPlaceAge and was never used before.
        std::array<std::optional<Angle>, 2> standingAt{};
        UtcTime looked{};  // when the operator looked at the mount
    };
    // Long enough to look, to walk to the computer and to start the program.
    static constexpr std::chrono::minutes kPlaceAge{10};

    TurnKeeper(const profile::InForce& profile, const Clock& clock, EventLog& log, Start start);

    // The drive was silent, restarted or lost count: its wrap must be judged again. `doubt` says why a proof by the
    // journal must not count, if so.
    void forget(Axis axis, const std::optional<QString>& doubt = std::nullopt);
    // With what is known about the drive: judges, and writes the answer into the drive. Call each tick.
    void judge(Axis axis, const survey::DriveFacts& facts, Drive& drive, SteadyTime now);
    // The operator is asked about the axis, and its drive can take an answer now.
    [[nodiscard]] Result<> mayChoose(Axis axis, const Drive& drive) const;
    // The operator has looked: the axis stands at about `angle`. Refused if the drive's direction contradicts it.
    Result<> choose(Axis axis, Angle angle, Drive& drive, const QString& source);

    // What a sensor on the antenna measures of the axis now, as a mechanical direction. It is evidence in the question.
    void setSensor(Axis axis, const std::optional<Angle>& heading) { m_sensor[index(axis)] = heading; }

    // How it has seen the azimuth turn: compared with where the axis was while its turn was known.
    void setCourse(const std::optional<SensorCourse>& course) { m_course = course; }

    [[nodiscard]] bool known(Axis axis) const { return state(axis).phase == Phase::Known; }
    [[nodiscard]] bool asked(Axis axis) const { return state(axis).phase == Phase::Asked; }
    // Why the place that was entered at the start of the program did not count; empty: it did, or there was none.
    [[nodiscard]] const QString& placeProblem(Axis axis) const { return m_placeProblems[index(axis)]; }
    // The question that waits for the operator; the places move along when the axis is jogged.
    [[nodiscard]] std::optional<TurnQuestion> question(Axis axis, const Drive& drive) const;

    // What the drive's position counts from is to be read (again): nothing can be proved without, and whoever sets the
    // position of a drive whose turn is known changes it.
    [[nodiscard]] bool needsOrigin(Axis axis, const survey::DriveFacts& facts) const;
    // Writes down where a known axis stands.
    void note(Axis axis, const survey::DriveFacts& facts, const Drive& drive, bool moving, SteadyTime now);
    void keep(Axis axis, const CrashStop& stop);
    [[nodiscard]] const memory::MountMemory& memory() const { return m_start.memory; }
    // True once after the position journal changed: it is to be saved.
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
        // What was read of the drive up to then is not true any more: it was silent, or its position was set.
        SteadyTime since = SteadyTime::min();
        TurnQuestion question{};
        MotorTurns reportedWhenAsked{};
        std::optional<SteadyTime> noted{};
        SteadyTime notBefore{};                                     // when the next judgement may be made
        moteus::HomeState homeState = moteus::HomeState::Relative;  // while the turn is known
        std::optional<moteus::CountOrigin> origin{};                // while the turn is known; nothing: not read yet
        survey::OriginReading other{};                              // the last one, if it was not the same
    };

    [[nodiscard]] State& state(Axis axis) { return m_states[index(axis)]; }
    [[nodiscard]] const State& state(Axis axis) const { return m_states[index(axis)]; }
    [[nodiscard]] std::optional<memory::TurnRecord>& record(Axis axis);
    [[nodiscard]] memory::DriveFrame frame(Axis axis, const survey::DriveFacts& facts, const Drive& drive,
                                           SteadyTime now) const;
    [[nodiscard]] bool isFresh(Axis axis, const survey::DriveFacts& facts) const;
    [[nodiscard]] bool ofTheOtherAxis(Axis axis, const survey::DriveFacts& facts) const;
    void judgeAnew(Axis axis, const survey::DriveFacts& facts, Drive& drive, SteadyTime now);
    void ask(Axis axis, const TurnQuestion& question, const Drive& drive);
    [[nodiscard]] std::optional<Angle> takeEnteredPlace(Axis axis);
    [[nodiscard]] Result<> enteredPlaceCounts() const;
    [[nodiscard]] bool chooseAsEntered(Axis axis, Angle place, Drive& drive);
    void countFromTheMiddle(Axis axis, Drive& drive);
    void watchJog(Axis axis, const Drive& drive);
    void watchOrigin(Axis axis, const survey::DriveFacts& facts);
    [[nodiscard]] bool isSameOrigin(Axis axis, const survey::DriveFacts& facts, const moteus::CountOrigin& one) const;
    [[nodiscard]] Angle period(Axis axis, const survey::DriveFacts& facts) const;
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
    std::optional<memory::CourseAnchor> m_anchor;  // of the azimuth
    bool m_changed = false;
};

}  // namespace boresight
