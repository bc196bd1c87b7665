// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim/axis_plant.h"
#include "core/sim/drive_config.h"
#include "core/units/sky.h"

// The mount that the simulated pair drives by default: a dish of 2 m on an azimuth-elevation positioner, with a 100:1
// gearbox for each axis. Azimuth 0…360° is 0…1 turn. The elevation drive is mounted inverted: 0° is -0.25 turn, 90° is
// -0.5 turn.
namespace boresight::sim {

struct ReferenceAxis
{
    double sign;  // turns of the drive = sign · (angle + offset) / 360°
    Angle offset;
    TravelRange travel;
    double gearRatio;  // turns of the rotor per turn of the output
    PlantSettings plant;
    ServoGains gains;

    [[nodiscard]] double toTurns(Angle angle) const { return sign * (angle + offset).turns(); }
    [[nodiscard]] Angle toAngle(double turns) const { return Angle::fromTurns(turns / sign) - offset; }
};

[[nodiscard]] const ReferenceAxis& referenceAxis(Axis axis);
// The feed of the dish, which turns its polarisation from -90° to 90°. Its own small motor turns it.
[[nodiscard]] const ReferenceAxis& referenceFeed();

}  // namespace boresight::sim
