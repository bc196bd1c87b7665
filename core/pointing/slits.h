// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/region.h"
#include "core/pointing/skyline.h"

#include <vector>

// Edges are permitted. So two adjacent keep-outs would leave their common edge as a way through. A keep-out that stands
// on the horizon or on a limit would leave the line below it. A slit that is narrower than the accuracy of the axes is
// not a way, so it is closed here. Pure.
namespace boresight::pointing {

inline constexpr Angle kSlit = Angle::fromDegrees(0.05);

// The parts of a keep-out that stand on the horizon or reach below it, extended down to the ground.
[[nodiscard]] std::vector<KeepOut> standingOnHorizon(const KeepOut& keepOut, const Skyline& skyline);

}  // namespace boresight::pointing
