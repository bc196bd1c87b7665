// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/supervision/retry_policy.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>
#include <vector>

// What crosses the port of the mount: how an axis is, what went wrong, and what the control alone knows. Plain values.
// Angles are mechanical (unwrapped).
namespace boresight {

// What moves or holds an axis now.
enum class AxisHand
{
    Off,          // nothing does: it gives way
    On,           // it is switched on, but follows no set-points
    Unordered,    // orders that are not ours
    TimedOut,     // what its own watchdog made of our last order, and that does not hold it
    HoldsItself,  // what its own watchdog made of our last order, and that holds it
    Held,         // our order to hold: it waits for the next motion
    Follows       // our set-points
};

struct AxisReport
{
    AxisHand hand = AxisHand::Off;
    bool answers = false;        // within the driver's own time; as of the last tick
    bool seen = false;           // what it does is reported; few lost replies in a row count as seen
    bool latched = false;        // a fault or time-out: it takes no orders before a re-arm
    bool changesHands = false;   // being taken over, recovered, switched off or given its position
    bool underOrders = false;    // it is not only listened to
    bool wrapKnown = false;      // which turn of the cable it is on
    bool wrapAsked = false;      // only the operator knows it
    std::optional<Angle> place;  // the last that is believed, whatever its age
    SteadyTime placed{};         // when that was measured
    std::optional<AngularRate> rate;
    std::optional<SteadyTime> heard;         // the last reply of any kind
    std::optional<double> voltage;           // V
    std::optional<double> torque;            // Nm
    std::optional<double> current;           // A
    std::optional<double> power;             // W, electrical; negative while the axis feeds the supply
    std::optional<double> boardTemperature;  // °C
    std::optional<double> motorTemperature;  // °C
};

// Of an axis that the mount does not have: it stands at 0, needs nothing and hinders nothing.
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

// What the control knows and no driver sees.
struct MountSituation
{
    bool wanted = false;        // something is asked of the mount, be it to hold
    bool settled = false;       // the set-points of both axes stand still
    bool faultLatched = false;  // a re-arm is waited for
    bool stopLatched = false;
    bool closing = false;  // the program ends
};

// An axis can not go on: the motion ends, and a re-arm is needed.
struct AxisTrouble
{
    Axis axis = Axis::Azimuth;
    supervision::LossClass loss = supervision::LossClass::Motion;
    QString what;
};

// What the supervision of one tick has found.
struct MountFindings
{
    bool interrupted = false;  // the place of an axis is not known any more: what was wanted means nothing now
    std::vector<AxisTrouble> troubles;
};

}  // namespace boresight
