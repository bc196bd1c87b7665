// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mount/simulation.h"
#include "core/profile/profile.h"

#include <QString>

// What the simulation of a control box needs in place of the values of the mount that is simulated. Pure.
namespace boresight::app {

// The profile with travel, limits and speeds that fit the box. Another mount would be refused by it. The profile of a
// rotator with a control box stays as it is, except for a travel that is too wide.
[[nodiscard]] profile::Profile fittedToBox(const Simulation& asked, profile::Profile profile);

// The folder below the one of the simulated profiles, so that the values of a box do not reach another simulation.
// Empty: no box was asked for.
[[nodiscard]] QString folderOfBox(const Simulation& asked);

}  // namespace boresight::app
