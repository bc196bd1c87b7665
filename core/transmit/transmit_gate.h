// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <optional>

// Decides whether the transmitter may transmit now. Pure, one thread.
namespace boresight::transmit {

// The reason why the transmitter is off.
enum class Obstacle
{
    None,
    Simulated,   // the mount is simulated, so no antenna points at the target
    Stopped,     // STOP is latched, or the program ends
    Fault,       // the mount has a fault or is not connected
    NoTarget,    // the mount is not aimed at a target
    NotUp,       // the target is below the horizon
    OutOfReach,  // the mount goes to the nearest permitted place instead
    NoPosition,  // the direction of the beam is unknown
    Away,        // the beam is too far from the target
    Settling     // the beam is near enough, but not yet for kSettled
};

struct GateInput
{
    Obstacle obstacle = Obstacle::None;    // an obstacle other than the error of the beam
    std::optional<SkyPointing> beam = {};  // as last measured
    std::optional<SkyPointing> target = {};
    Angle within;  // the limit: the transmitter is on only while the error is smaller
};

struct GateDecision
{
    Obstacle obstacle = Obstacle::NoTarget;  // None: the transmitter may transmit
    std::optional<Angle> error = {};         // angle on the sky between beam and target

    [[nodiscard]] bool on() const { return obstacle == Obstacle::None; }
    bool operator==(const GateDecision&) const = default;
};

// Goes off in the same tick in which the error reaches the limit or another obstacle appears. Goes on again after the
// error was below kComesBack times the limit, without any obstacle, for kSettled. So the output cannot chatter.
class TransmitGate
{
public:
    static constexpr double kComesBack = 0.9;
    static constexpr Seconds kSettled{0.5};

    [[nodiscard]] GateDecision decide(const GateInput& input, SteadyTime now);

private:
    bool m_on = false;
    std::optional<SteadyTime> m_inside;  // when the last obstacle ended; empty: there is an obstacle
};

}  // namespace boresight::transmit
