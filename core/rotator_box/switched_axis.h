// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/motor_starts.h"
#include "core/tracking/leeway.h"
#include "core/units/quantity.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>

// One axis whose motor is only switched on and off, by a relay that wears out with every start. It is sent elsewhere
// only when its set-point is farther away than the leeway permits, and what is sent is inside of that. A motor that
// runs is sent on, which is no start. A limit of starts makes tracking coarser, and nothing else: an axis that runs,
// has to be exact, or is on its way to a place is never kept waiting. Angles as the rotator counts them. Pure: time and
// places are passed in.
namespace boresight {

class SwitchedAxis
{
public:
    static constexpr Angle kFarthest = Angle::fromDegrees(12.0);  // from where it is: the line may fail
    static constexpr Angle kMostCoast = Angle::fromDegrees(2.0);  // that it is reckoned with
    static constexpr std::chrono::milliseconds kSettles{600};     // without another place: it stands
    static constexpr std::chrono::seconds kCoastsFor{3};          // at most; then something else turns it

    struct Habits
    {
        Angle step;                    // it is sent to multiples of it
        Angle count;                   // places that differ by two of these may be noise
        int mostStarts = 0;            // a minute; 0: any number
        std::optional<Angle> coast{};  // empty: as measured
    };

    void setHabits(const Habits& habits) { m_habits = habits; }
    // Taken over where it stands: nothing is sent before the set-point goes elsewhere.
    void begin();
    void see(Angle place, SteadyTime now);
    // What comes next may be another rotator.
    void forget() { m_readings = 0; }
    // Where it is to be sent now; empty: the last target is good.
    [[nodiscard]] std::optional<Angle> next(const tracking::Leeway& leeway, SteadyTime now);
    // It was sent there.
    void sent(Angle target, SteadyTime now);
    void stopped(SteadyTime now);

    // The middle of what was reported since it stands.
    [[nodiscard]] Angle place() const { return 0.5 * (m_low + m_high); }
    // What a command for both axes names so that this one goes on as it does.
    [[nodiscard]] Angle unchanged() const;
    // Its motor is off, or nobody knows: any target would switch it on.
    [[nodiscard]] bool coasts() const { return m_phase == Phase::Coasts; }
    // It waits for the limit of starts.
    [[nodiscard]] bool spared() const { return m_spared; }
    // Where it shall end.
    [[nodiscard]] Angle aim() const { return m_aim.value_or(place()); }
    // The last that was sent since it was taken over or stopped.
    [[nodiscard]] const std::optional<Angle>& target() const { return m_target; }
    [[nodiscard]] MotorStarts starts(SteadyTime now) const;

private:
    enum class Phase
    {
        Stands,
        Runs,
        Coasts
    };

    [[nodiscard]] bool standsAt(Angle target) const;
    [[nodiscard]] Angle coast() const
    {
        return std::min(m_habits.coast.value_or(m_coast.value_or(Angle{})), kMostCoast);
    }
    [[nodiscard]] Angle aimOf(const tracking::Leeway& leeway) const;
    [[nodiscard]] Angle shortened(Angle aim) const;
    [[nodiscard]] bool isDue(Angle aim, const tracking::Leeway& leeway, SteadyTime now);
    [[nodiscard]] bool mayStart(SteadyTime now) const;
    void settle();

    Habits m_habits;
    Phase m_phase = Phase::Stands;
    bool m_spared = false;
    // What it reported since it stands, or the last two counts of a motion.
    Angle m_low;
    Angle m_high;
    int m_readings = 0;             // of them
    SteadyTime m_changed{};         // it moved, as far as one can see
    SteadyTime m_arrived{};         // or was stopped
    std::optional<Angle> m_aim;     // where it shall end
    std::optional<Angle> m_target;  // what was sent for that
    double m_way = 0.0;             // of the motor: -1, 1
    Angle m_reached;                // on it, the farthest
    std::optional<Angle> m_coast;
    std::deque<SteadyTime> m_starts;  // of the last minute
    std::uint64_t m_total = 0;
};

}  // namespace boresight
