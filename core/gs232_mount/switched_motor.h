// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <cstdint>
#include <deque>
#include <optional>

// The motor of one axis that is only switched on and off: whether it runs, how far it coasts, how often it was started,
// and whether it is to be started now. A start that has to wait is not remembered: each tick decides anew from what is
// wanted then. Angles are whole degrees of the box. Pure: time is passed in.
namespace boresight::gs232 {

class SwitchedMotor
{
public:
    static constexpr Angle kStep = Angle::fromDegrees(1.0);
    static constexpr Angle kMiss = Angle::fromDegrees(2.0);  // such a rotator ends that far from its target
    // It must not run farther than this when the line fails. Longer ways are sent piece by piece while it runs.
    static constexpr Angle kFarthest = Angle::fromDegrees(12.0);
    static constexpr Angle kMostCoast = Angle::fromDegrees(3.0);
    static constexpr Angle kOverrun = Angle::fromDegrees(6.0);  // beyond its target: no coast
    static constexpr std::chrono::seconds kStill{1};            // no other place for so long: it stands
    static constexpr std::chrono::seconds kNear{2};             // the same near a target that it has not met

    struct Wish
    {
        Angle end;             // where it is to go
        Angle target;          // what it follows, where that is now
        bool follows = false;  // else it has to meet `end`
        Angle slack{};         // of what it follows
        int most = 1;          // starts in a minute
    };
    enum class Act
    {
        Stay,
        Wait,  // it was started too often
        Go,
        Stop  // it runs the wrong way, or too far
    };
    struct Decision
    {
        Act act = Act::Stay;
        Angle to{};  // where it is to be sent

        bool operator==(const Decision&) const = default;
    };

    [[nodiscard]] Decision decide(const Wish& wish, SteadyTime now) const;

    void place(Angle place, SteadyTime now);  // as reported
    // The box was sent to `to`, on the way to `end`.
    void sent(Angle to, Angle end, SteadyTime now);
    void sentAgain(SteadyTime now) { count(now); }  // it had stopped by itself
    void stopped(SteadyTime now);
    // It stands where it was reported, and was sent nowhere.
    void beginHere();
    // Another box, or a silence. The starts stay.
    void forget();

    [[nodiscard]] bool runs() const { return m_state == State::Runs; }
    [[nodiscard]] bool stands() const { return m_state == State::Stands; }
    // It is about to arrive, arrives or coasts: to name its target again could start it again.
    [[nodiscard]] bool ends() const;
    // It was sent there and came as near as it can. Whoever turns it away then, it is not started again for that.
    [[nodiscard]] bool hasMet(Angle end) const;
    [[nodiscard]] bool isAt(Angle end) const;  // and is still there
    [[nodiscard]] bool overran() const;        // its relay did not open
    // It would have to turn round for this.
    [[nodiscard]] bool reverses(Angle to) const;
    // Where it counts as being: on the way that it was sent, which is permitted, if it is there within its miss.
    [[nodiscard]] Angle believed() const;
    [[nodiscard]] Angle coast() const { return m_coast; }
    [[nodiscard]] Angle deadBand(Angle slack) const;

    [[nodiscard]] std::uint64_t starts() const { return m_total; }
    [[nodiscard]] int startsInLastMinute(SteadyTime now) const;

private:
    enum class State
    {
        Unknown,
        Stands,
        Runs,
        Settles  // it was stopped, or has arrived, or somebody else moves it
    };

    void count(SteadyTime now);
    void standNow();
    [[nodiscard]] double ahead(Angle of) const;  // degrees from its place, in the direction of its order
    [[nodiscard]] bool mayStart(int most, SteadyTime now) const;
    [[nodiscard]] Decision decideRunning(const Wish& wish) const;
    [[nodiscard]] Angle aim(Angle end) const;

    State m_state = State::Unknown;
    std::optional<Angle> m_place;
    Angle m_before{};  // the place before this one
    SteadyTime m_changed{};
    Angle m_rest{};  // where it stood last
    Angle m_from{};  // of its order
    Angle m_to{};
    Angle m_end{};
    double m_sign = 1.0;     // of its way
    bool m_isFinal = false;  // no piece of the way to its end is left
    bool m_met = false;
    bool m_arrived = false;  // it settles because it has arrived
    Angle m_coast{};         // beyond where it was sent, as measured
    std::uint64_t m_total = 0;
    std::deque<SteadyTime> m_starts;  // of the last minute
};

}  // namespace boresight::gs232
