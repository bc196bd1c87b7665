// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <optional>

// One axis as seen in one tick. Mechanical angles, Nm, V, °C.
namespace boresight::supervision {

struct AxisObservation
{
    SteadyTime now{};
    SteadyTime received{};  // when the last reply came
    bool fresh = false;     // a new reply since the last tick
    Angle actual;           // of the last reply
    bool engaging = false;  // the drive is told to hold where it is, and has not yet said that it does
    bool engaged = false;   // set-points are sent
    Angle commanded;        // the set-point last sent; these two count only while engaged
    AngularRate commandedRate;
    double torque = 0.0;
    double voltage = 0.0;
    double boardTemperature = 0.0;
    std::optional<double> motorTemperature;  // empty without a sensor
    int activeLimit = 0;     // the moteus code (96…105) of what the drive is limited by now; 0: nothing
    bool turnKnown = false;  // else `actual` is right but for whole turns of the rotor
};

}  // namespace boresight::supervision
