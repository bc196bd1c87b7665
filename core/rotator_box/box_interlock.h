// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/capabilities.h"
#include "core/profile/profile.h"
#include "core/units/sky.h"

#include <QString>

#include <array>

// Whether a profile fits a rotator that counts its angles itself. Pure.
namespace boresight {

// The multiples of `step` inside the travel; min > max if there is none.
[[nodiscard]] TravelRange stepsIn(const TravelRange& travel, Angle step);
// "azimuth", "elevation": the table of an axis in the profile.
[[nodiscard]] QString tableOf(Axis axis);
// A rotator does not report its own steps, nor whether its motors are only switched on and off, so the profile does.
// `each`: what the protocol permits. Its steps stay where they are coarser.
[[nodiscard]] std::array<AxisCapabilities, 2> asInProfile(const AxisCapabilities& each,
                                                          const profile::Profile& profile);
// The rotator counts its angles itself, and its count is the angle of the axis. So a sign or an offset in the profile
// would have no effect, and is refused.
[[nodiscard]] Result<> countsAsTheRotator(const profile::Profile& profile, Axis axis);

}  // namespace boresight
