// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/pointing/permitted_region.h"

#include <cstddef>
#include <vector>

// The route from one position of the axes to another around forbidden places. Both axes move independently of each
// other, so the whole box of each leg must be permitted. Pure, any thread.
namespace boresight::pointing {

// A search ends after this many comparisons with a keep-out, whether it found a route or not, because the control tick
// waits for it. The limit is a count, not a time, so that the same request has the same answer on every computer.
inline constexpr std::size_t kMostSteps = 1'500'000;

// The positions to visit in order, ending with `to`. It is the only one if the direct way is free. An error, with its
// reason, if there is no way or none was found within kMostSteps. `speed` of the axes decides which way is the
// quickest. Each leg costs `bend` in addition.
[[nodiscard]] Result<std::vector<AxisPosition>> route(const PermittedRegion& region, const AxisPosition& from,
                                                      const AxisPosition& to, const AxisRates& speed,
                                                      Seconds bend = Seconds(0.5), std::size_t steps = kMostSteps);

}  // namespace boresight::pointing
