// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"
#include "core/units/sky.h"

#include <functional>

namespace boresight::profile {

// Returns a function that judges a true direction: true if this antenna may point there on any wrap, within the limits,
// above the horizon and outside the keep-outs of this profile. Pure value, any thread.
[[nodiscard]] std::function<bool(const SkyPointing&)> clearSky(const Profile& profile,
                                                               const pointing::Antenna& antenna);

}  // namespace boresight::profile
