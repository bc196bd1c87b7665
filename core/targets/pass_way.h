// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"
#include "core/passes/pass.h"
#include "core/targets/sky_moment.h"

namespace boresight::targets {

// The way of a satellite through the sky during its pass, in 180 steps. Empty: the orbit has no answer. Pure.
[[nodiscard]] SkyWay wayOf(const passes::Pass& pass, const orbit::ElementSet& elements, const Site& site);

}  // namespace boresight::targets
