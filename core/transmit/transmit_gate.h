// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <optional>

// Whether the transmitter may transmit now. Pure, one thread.
namespace boresight::transmit {

// What keeps it off.
enum class Obstacle
{
    None,
    Simulated,   // the antenna points nowhere
    Stopped,     // STOP is latched, or the program ends
    Fault,       // of the mount, or it is not connected
    NoTarget,    // nothing that the mount is aimed at
    NotUp,       // the target is below the horizon
    OutOfReach,  // the mount goes to the nearest permitted place instead
    NoPosition,  // nobody knows where the beam is now
    Away,        // too far from the target
    Settling     // near enough for too short a time
};

struct GateInput
{
    Obstacle obstacle = Obstacle::None;    // that has nothing to do with directions
    std::optional<SkyPointing> beam = {};  // as measured just now
    std::optional<SkyPointing> target = {};
    Angle within;  // the largest error with which it is on
};

struct GateDecision
{
    Obstacle obstacle = Obstacle::NoTarget;  // None: on
    std::optional<Angle> error = {};         // of the beam, on the sky

    [[nodiscard]] bool on() const { return obstacle == Obstacle::None; }
    bool operator==(const GateDecision&) const = default;
};

// Off in the tick in which the beam leaves the limit or anything else is in the way. On again not before the error was
// below kComesBack of the limit and nothing was in the way for kSettled, so that nothing can make it chatter.
class TransmitGate
{
public:
    static constexpr double kComesBack = 0.9;
    static constexpr Seconds kSettled{0.5};

    [[nodiscard]] GateDecision decide(const GateInput& input, SteadyTime now);

private:
    bool m_on = false;
    std::optional<SteadyTime> m_inside;  // since then; empty: something is in the way
};

}  // namespace boresight::transmit
