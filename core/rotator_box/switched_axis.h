// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/motor_starts.h"
#include "core/tracking/leeway.h"
#include "core/units/quantity.h"
#include "core/units/sky.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>

// One axis whose motor is only switched on and off, by a relay that wears out with every start. It gets a new target
// only when its set-point is farther away than the leeway permits. The target is inside the leeway. A running motor is
// sent on, which is no start. A limit of starts makes tracking coarser and nothing else: an axis that runs, has to be
// exact, or is on its way to a place never waits for it. Angles as the rotator counts them. Pure: time and positions
// are passed in.
namespace boresight {

class SwitchedAxis
{
public:
    static constexpr Angle kFarthest = Angle::fromDegrees(12.0);    // from its position, because the line may fail
    static constexpr Angle kMostCoast = Angle::fromDegrees(2.0);    // more is not made up for
    static constexpr std::chrono::milliseconds kSettles{600};       // without another position it stands
    static constexpr std::chrono::milliseconds kSettlesWorn{2000};  // with a worn potentiometer
    static constexpr std::chrono::seconds kCoastsFor{3};            // at most; then something else turns the axis

    struct Habits
    {
        Angle step;                    // targets are multiples of it
        Angle count;                   // positions that differ by two of these may be noise
        int mostStarts = 0;            // a minute; 0: any number
        std::optional<Angle> coast{};  // empty: as measured
    };

    explicit SwitchedAxis(const Habits& habits) : m_habits(habits) {}

    void setHabits(const Habits& habits) { m_habits = habits; }
    // The axis is taken over where it stands.
    void begin();
    void see(Angle place, SteadyTime now);
    // The next positions may be those of another rotator.
    void forget()
    {
        m_readings = 0;
        m_isWorn = false;
    }
    // The new target. Empty: the last one is good. With `waits` the other axis coasts: then the motor is not started,
    // and a running one only gets a target that is nearer, or behind it.
    [[nodiscard]] std::optional<Angle> next(const tracking::Leeway& leeway, SteadyTime now, bool waits = false);
    // The target for an axis that did not obey the last one.
    [[nodiscard]] Angle again(const tracking::Leeway& leeway);
    void sent(Angle target, SteadyTime now);
    void stopped(SteadyTime now);

    // The middle of the positions since the axis stands.
    [[nodiscard]] Angle place() const { return 0.5 * (m_same.min + m_same.max); }
    // The target with which this axis continues its present motion, or stands. Empty if its position is unknown.
    [[nodiscard]] std::optional<Angle> unchanged() const;
    // The motor was just switched off. Any target may switch it on again.
    [[nodiscard]] bool coasts() const { return m_phase == Phase::Coasts; }
    [[nodiscard]] bool stands() const { return m_phase == Phase::Stands; }
    // It waits for the limit of starts.
    [[nodiscard]] bool spared() const { return m_spared; }
    // Where the motion has to end.
    [[nodiscard]] Angle aim() const { return m_aim.value_or(place()); }
    // The last target since it was taken over or stopped.
    [[nodiscard]] const std::optional<Angle>& target() const { return m_target; }
    [[nodiscard]] MotorStarts starts(SteadyTime now) const;

private:
    enum class Phase
    {
        Stands,
        Runs,
        Coasts
    };

    [[nodiscard]] bool isMiddleKnown() const;
    [[nodiscard]] bool standsAt(Angle target) const;
    [[nodiscard]] bool isOutside(const TravelRange& within) const;
    [[nodiscard]] Angle coast() const
    {
        return std::min(m_habits.coast.value_or(m_coast.value_or(Angle{})), kMostCoast);
    }
    [[nodiscard]] Angle aimOf(const tracking::Leeway& leeway) const;
    [[nodiscard]] Angle targetFor(Angle aim, const tracking::Leeway& leeway) const;
    [[nodiscard]] Angle shortened(Angle aim) const;
    [[nodiscard]] bool isDue(Angle aim, const tracking::Leeway& leeway, SteadyTime now, bool waits);
    [[nodiscard]] bool mayStart(SteadyTime now) const;
    void settle();

    Habits m_habits;
    Phase m_phase = Phase::Stands;
    bool m_spared = false;
    TravelRange m_same{};           // the positions since the axis stands, or the last two counts of a motion
    int m_readings = 0;             // their number
    bool m_isWorn = false;          // a standing axis has reported three counts
    SteadyTime m_changed{};         // when it last moved visibly
    SteadyTime m_arrived{};         // or was stopped
    std::optional<Angle> m_aim;     // where the motion has to end
    std::optional<Angle> m_target;  // the target that was sent for this
    double m_way = 0.0;             // direction of the motor: -1, 1
    Angle m_reached;                // the farthest position in this direction
    std::optional<Angle> m_coast;
    std::deque<SteadyTime> m_starts;  // of the last minute
    std::uint64_t m_total = 0;
};

}  // namespace boresight
