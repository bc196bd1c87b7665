// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/commissioning.h"
#include "core/profile/profile.h"

#include <optional>

// Whether a simulated mount replaces the real one, and which driver turns it. This is a mode of the program and works
// with any profile. No profile and no file stores it. Settings and findings of the simulation go into separate files.
// Pure.
namespace boresight {

struct Simulation
{
    bool on = false;
    // The driver of every axis of the profile. Empty: each axis has the driver that the profile names.
    std::optional<profile::AxisDriver> driver{};
    profile::SimulatedDevice device = profile::SimulatedDevice::Usual;

    static const Simulation Off;
    static const Simulation Reference;  // the drivers of the profile; by default the reference mount

    bool operator==(const Simulation&) const = default;
};
inline constexpr Simulation Simulation::Off{};
inline constexpr Simulation Simulation::Reference{.on = true};

// The simulation that runs with this profile if `asked` was requested. A profile without the bus of a real mount always
// gets the simulated one.
[[nodiscard]] inline Simulation simulationOf(const Simulation& asked, const profile::Profile& profile)
{
    return asked == Simulation::Off && profile::namesNoBus(profile) ? Simulation::Reference : asked;
}

// The driver of this axis. An axis that the profile does not have is not simulated.
[[nodiscard]] inline profile::AxisDriver driverOf(const Simulation& simulation, const profile::Profile& profile,
                                                  Axis axis)
{
    const profile::AxisDriver named = profile.axis(axis).driver;
    return named == profile::AxisDriver::None ? named : simulation.driver.value_or(named);
}

// True if an orientation sensor is simulated together with the mount.
[[nodiscard]] inline bool hasSensor(const Simulation& simulation, const profile::Profile& profile)
{
    const profile::AxisDriver azimuth = driverOf(simulation, profile, Axis::Azimuth);
    return simulation.on && azimuth == driverOf(simulation, profile, Axis::Elevation) &&
           profile::kindOf(azimuth).sensorInside;
}

}  // namespace boresight
