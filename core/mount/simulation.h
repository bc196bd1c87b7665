// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/commissioning.h"
#include "core/profile/profile.h"

#include <optional>

// Whether a mount inside the program stands in place of the real one, and what turns it. A mode of the program, over
// any profile: no profile and no file holds it. What is set and found in it goes to files of its own. Pure.
namespace boresight {

struct Simulation
{
    bool on = false;
    // Turns every axis of the profile. Without one each axis has the driver that the profile names.
    std::optional<profile::AxisDriver> driver{};

    static const Simulation Off;
    static const Simulation Reference;  // as the profile names: the reference mount by default

    bool operator==(const Simulation&) const = default;
};
inline constexpr Simulation Simulation::Off{};
inline constexpr Simulation Simulation::Reference{.on = true};

// What runs with this profile when `asked` was asked for. A profile that names no bus of a real mount has nothing else
// than the simulated one.
[[nodiscard]] inline Simulation simulationOf(const Simulation& asked, const profile::Profile& profile)
{
    return asked == Simulation::Off && profile::namesNoBus(profile) ? Simulation::Reference : asked;
}

// What turns this axis. An axis that the profile does not have is not simulated either.
[[nodiscard]] inline profile::AxisDriver driverOf(const Simulation& simulation, const profile::Profile& profile,
                                                  Axis axis)
{
    const profile::AxisDriver named = profile.axis(axis).driver;
    return named == profile::AxisDriver::None ? named : simulation.driver.value_or(named);
}

// Whether an orientation sensor is simulated with the mount.
[[nodiscard]] inline bool hasSensor(const Simulation& simulation, const profile::Profile& profile)
{
    const profile::AxisDriver azimuth = driverOf(simulation, profile, Axis::Azimuth);
    return simulation.on && azimuth == driverOf(simulation, profile, Axis::Elevation) &&
           profile::kindOf(azimuth).sensorInside;
}

}  // namespace boresight
