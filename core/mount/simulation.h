// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/commissioning.h"
#include "core/profile/profile.h"

// Whether a mount inside the program stands in place of the real one, and which. A mode of the program, over any
// profile: no profile and no file holds it. What is set and found in it goes to files of its own. Pure.
namespace boresight {

enum class Simulation
{
    Off,
    Reference,  // the reference mount with its bus, or the rotators that the profile names
    Simple,     // the plainest rotator, on all axes of the profile
};

// What runs with this profile when `asked` was asked for. A profile that names no bus of a real mount has nothing else
// than the simulated one.
[[nodiscard]] inline Simulation simulationOf(Simulation asked, const profile::Profile& profile)
{
    return asked == Simulation::Off && profile::namesNoBus(profile) ? Simulation::Reference : asked;
}

}  // namespace boresight
