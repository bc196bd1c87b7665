// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/supervision/retry_policy.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>
#include <vector>

// The values of the port of the mount: the state of an axis, faults, and facts that only the control knows. Plain
// values. Angles are mechanical (unwrapped).
namespace boresight {

// What moves or holds an axis now.
enum class AxisHand
{
    Off,          // nothing holds it: it gives way
    On,           // it is switched on, but follows no set-points
    Unordered,    // it carries out commands that are not ours
    TimedOut,     // its own watchdog ended our last command, and it is not held
    HoldsItself,  // its own watchdog ended our last command, and it is held
    Held,         // our command holds it until the next motion
    Follows       // it follows our set-points
};

struct AxisReport
{
    AxisHand hand = AxisHand::Off;
    bool answers = false;        // within the time of the driver, as of the last tick
    bool seen = false;           // its movement is reported; a few lost replies in a row are permitted
    bool latched = false;        // a fault or time-out: it accepts no commands before a re-arm
    bool changesHands = false;   // being taken over, recovered, switched off or given its position
    bool underOrders = false;    // it gets commands, not only queries
    bool wrapKnown = false;      // it is known which cable wrap it is on
    bool wrapAsked = false;      // the operator is asked for the wrap
    std::optional<Angle> place;  // the last position that is believed, of any age
    SteadyTime placed{};         // when `place` was measured
    std::optional<AngularRate> rate;
    std::optional<SteadyTime> heard;         // the last reply of any kind
    std::optional<double> voltage;           // V
    std::optional<double> torque;            // Nm
    std::optional<double> current;           // A
    std::optional<double> power;             // W, electrical; negative while the axis feeds the supply
    std::optional<double> boardTemperature;  // °C
    std::optional<double> motorTemperature;  // °C
};

// The report of an axis that the mount does not have: it stands at 0, needs nothing and hinders nothing.
[[nodiscard]] inline AxisReport reportOfMissingAxis(bool follows, SteadyTime now)
{
    return {.hand = follows ? AxisHand::Follows : AxisHand::HoldsItself,
            .answers = true,
            .seen = true,
            .underOrders = follows,
            .wrapKnown = true,
            .place = Angle{},
            .placed = now,
            .heard = now};
}

// Facts that the control knows and no driver sees.
struct MountSituation
{
    bool wanted = false;        // the mount has a task, which may be to hold
    bool settled = false;       // the set-points of both axes stand still
    bool faultLatched = false;  // waits for a re-arm
    bool stopLatched = false;
    bool closing = false;  // the program is ending
};

// An axis can not continue: the motion ends, and a re-arm is needed.
struct AxisTrouble
{
    Axis axis = Axis::Azimuth;
    supervision::LossClass loss = supervision::LossClass::Motion;
    QString what;
};

// The result of the supervision in one tick.
struct MountFindings
{
    bool homed = false;        // a home run has ended: the axes are counted from their switches again
    bool interrupted = false;  // the position of an axis became unknown, so the target means nothing any more
    std::vector<AxisTrouble> troubles;
};

}  // namespace boresight
