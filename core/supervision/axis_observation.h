// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>

// One axis as seen in one tick. Mechanical angles, Nm, V, °C.
namespace boresight::supervision {

// PlaceBelief::Leap in mechanical angles.
struct AngleLeap
{
    Angle by;  // signed
    Angle to;
    Seconds within{0.0};
};

struct AxisObservation
{
    SteadyTime now{};
    UtcTime utc{};          // the same moment, for sentences
    SteadyTime received{};  // when the last reply came
    bool fresh = false;     // a new reply since the last tick
    bool placed = true;     // it says a place that is believed; else `actual` is older and says nothing new
    Angle actual;           // the last believed place
    // What an earlier reply said, and has turned out to be false.
    std::optional<AngleLeap> falsePlace{};
    // Several replies that agree have shown that the angle has jumped to `actual`.
    std::optional<AngleLeap> jumped{};
    bool engaging = false;  // the drive was commanded to hold, and has not yet reported that it does
    bool engaged = false;   // set-points are sent
    Angle commanded;        // the set-point last sent; these two count only while engaged
    AngularRate commandedRate;
    // Each is empty if the drive does not say it.
    std::optional<double> torque{};
    std::optional<double> voltage{};
    std::optional<double> boardTemperature{};
    std::optional<double> motorTemperature{};
    QString limit{};  // of the drive now, to be added to a sentence: "; limit 102 of the drive: …"; empty: none
    bool turnKnown = false;  // else `actual` is right but for whole turns of the rotor
};

}  // namespace boresight::supervision
