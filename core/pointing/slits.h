// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/region.h"
#include "core/pointing/skyline.h"

#include <vector>

// Edges are permitted, so two keep-outs side by side would leave their common edge as a way through, and a keep-out
// that stands on the horizon or on a limit the line below it. What is narrower than the axes are exact is no way: it is
// closed here. Pure.
namespace boresight::pointing {

inline constexpr Angle kSlit = Angle::fromDegrees(0.05);

// The parts of a keep-out that stand on the horizon, or reach below it, brought down to the ground.
[[nodiscard]] std::vector<KeepOut> standingOnHorizon(const KeepOut& keepOut, const Skyline& skyline);

}  // namespace boresight::pointing
