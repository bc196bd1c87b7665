// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <optional>

// The order in which the brake of the axes is released, the axes move, and the brake is set. Pure: time is passed in.
namespace boresight::brake {

enum class BrakeState
{
    Set,
    Releasing,  // no motion yet
    Released,   // the axes may move
    Setting
};

struct BrakeTimes
{
    Seconds switching;  // the time that the brake needs to open or to close
    Seconds setAfter;   // the brake is set after this time without motion
    Seconds urgent;     // the same after STOP, after a fault and at the end of the program
    Seconds blind;      // the same while a drive is silent. Its axis stands still after this time
};

// The situation in one tick.
struct BrakeInput
{
    bool wanted = false;                // the set-points would move if they were permitted to
    bool moves = false;                 // a set-point or an axis moves
    bool isLimp = false;                // nothing holds an axis: its drive is off, in fault or without torque
    bool isBlind = false;               // the drive of an axis is silent
    bool isUrgent = false;              // STOP, a fault or the end of the program: the brake is set at standstill
    std::optional<bool> released = {};  // what the output answered to the last order; empty: no answer yet
};

class BrakeSequence
{
public:
    // Once per tick.
    void step(const BrakeInput& input, const BrakeTimes& times, SteadyTime now);

    // The order to the output: on.
    [[nodiscard]] bool releases() const { return m_releases; }
    [[nodiscard]] bool mayMove() const { return m_state == BrakeState::Released; }
    [[nodiscard]] BrakeState state() const { return m_state; }

private:
    [[nodiscard]] bool decide(const BrakeInput& input, const BrakeTimes& times, SteadyTime now) const;

    BrakeState m_state = BrakeState::Setting;
    bool m_releases = false;
    bool m_wasOpen = false;               // since the order to release
    std::optional<SteadyTime> m_still;    // since when nothing moves or wants to
    std::optional<SteadyTime> m_reached;  // since when the output is as ordered
};

}  // namespace boresight::brake
