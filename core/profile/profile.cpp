// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile.h"

#include <algorithm>

namespace boresight::profile {

namespace {

// The jerk is ten times the acceleration (per second), so the averaging takes 0.2 s. An axis that tracks a satellite at
// 1°/s then stands still 0.3 s after a stop.
tracking::MotionLimits limitsOf(double degreesPerSecond, double degreesPerSecond2)
{
    return {.speed = AngularRate::fromDegrees(degreesPerSecond),
            .acceleration = AngularAcceleration::fromDegrees(degreesPerSecond2),
            .jerk = AngularJerk::fromDegrees(10.0 * degreesPerSecond2)};
}

}  // namespace

// Torque for a dish of 2 m: 20 kg m² at 10 °/s² need 4 Nm and friction needs as much. The rest is for wind.
AxisSettings referenceAzimuth()
{
    return {.id = 1,
            .geometry = {.gearRatio = 100.0, .travel = {.min = -90_deg, .max = 450_deg}},
            .limits = limitsOf(10.0, 10.0),
            .maxTorque = 50.0};
}

AxisSettings referenceElevation()
{
    return {.id = 2,
            .geometry = {.sign = -1, .offset = 90_deg, .gearRatio = 100.0, .travel = {.min = 0_deg, .max = 90_deg}},
            .limits = limitsOf(8.0, 8.0),
            .maxTorque = 50.0};
}

// The feed of a small dish. Its board counts turns of the axis.
AxisSettings referenceThirdAxis()
{
    return {.id = 0,
            .geometry = {.gearIn = pointing::GearIn::Host, .travel = {.min = -90_deg, .max = 90_deg}},
            .limits = limitsOf(5.0, 10.0),
            .maxTorque = 1.0};
}

std::vector<pointing::Antenna> Profile::allAntennas() const
{
    std::vector<pointing::Antenna> all{{.beamWidth = mount.beamWidth}};
    all.insert(all.end(), antennas.begin(), antennas.end());
    return all;
}

// To either side 0.15 of the beam costs 0.3 dB, and leaves what a motor needs to start within a quarter of the beam.
Angle Profile::deadBand(const pointing::Antenna& antenna) const
{
    constexpr Angle kWidestBand = Angle::fromDegrees(5.0);
    return rotator.deadBand > Angle{} ? rotator.deadBand : std::min(0.15 * antenna.beamWidth, kWidestBand);
}

pointing::Antenna Profile::antenna(const std::string& name) const
{
    const std::vector<pointing::Antenna> all = allAntennas();
    const auto found = std::ranges::find(all, name, &pointing::Antenna::name);
    return found == all.end() ? all.front() : *found;
}

}  // namespace boresight::profile
