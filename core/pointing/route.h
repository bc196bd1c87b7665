// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/pointing/permitted_region.h"

#include <cstddef>
#include <vector>

// The way from one place of the axes to another around what is forbidden. Both axes move independently of each other,
// so that each leg of a way is one whose whole box is permitted. Pure, any thread.
namespace boresight::pointing {

// A search ends after this many comparisons with a keep-out, found or not: the control tick waits for it. Counted, not
// timed, so that the same request has the same answer on every computer.
inline constexpr std::size_t kMostSteps = 1'500'000;

// The places to go to one after the other, the last is `to`; one alone if the way is free. An error with its reason
// when there is none, or when none was found in so many steps. `speed` of the axes decides which of several ways is the
// quickest; each leg costs `bend` besides.
[[nodiscard]] Result<std::vector<AxisPosition>> route(const PermittedRegion& region, const AxisPosition& from,
                                                      const AxisPosition& to, const AxisRates& speed,
                                                      Seconds bend = Seconds(0.5), std::size_t steps = kMostSteps);

}  // namespace boresight::pointing
