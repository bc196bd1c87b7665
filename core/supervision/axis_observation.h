// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>

// One axis as seen in one tick. Mechanical angles, Nm, V, °C.
namespace boresight::supervision {

// PlaceBelief::Leap, converted to mechanical angles.
struct AngleLeap
{
    Angle by;  // signed
    Angle to;
    Seconds within{0.0};
};

struct AxisObservation
{
    SteadyTime now{};
    UtcTime utc{};          // the same moment, for the text of an alarm
    SteadyTime received{};  // when the last reply arrived
    bool fresh = false;     // a new reply has arrived since the last tick
    bool placed = true;     // the last reply has a believed place; else `actual` is from an older reply
    Angle actual;           // the last believed place
    // The place of an earlier reply that has turned out to be false.
    std::optional<AngleLeap> falsePlace{};
    // Several agreeing replies have shown that the angle has jumped to `actual`.
    std::optional<AngleLeap> jumped{};
    bool engaging = false;  // the drive was commanded to hold its position and has not confirmed it yet
    bool engaged = false;   // set-points are sent to the drive
    Angle commanded;        // the last set-point; it and its rate are valid only while engaged
    AngularRate commandedRate;
    // Empty: the drive does not report this value.
    std::optional<double> torque{};
    std::optional<double> voltage{};
    std::optional<double> boardTemperature{};
    std::optional<double> motorTemperature{};
    QString limit{};         // reported by the drive, added to an alarm: "; limit 102 of the drive: …"; empty: none
    bool turnKnown = false;  // else `actual` may be wrong by whole turns of the rotor
    // The wrap is known only from what the operator entered, and it may be wrong.
    bool turnEntered = false;
};

}  // namespace boresight::supervision
