// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/pass_path.h"

#include <vector>

// The motion of the axes when they are sent along a path that they cannot follow everywhere: it turns back by 360°, or
// leads through a place that is not permitted. Pure.
namespace boresight::plan {

// One state for each point of the path. The motion begins with the first wanted state. It keeps to the permitted places
// nearest to the wanted ones, goes around forbidden places on the quickest route, and moves as fast as the limits allow
// until it is back on the path.
[[nodiscard]] std::vector<AxisStates> driven(const PassPath& path, const std::vector<AxisStates>& wanted,
                                             const PlanMount& mount);

// Whether the axes can follow the wanted states as they are.
[[nodiscard]] bool canFollow(const PassPath& path, const std::vector<AxisStates>& wanted, const PlanMount& mount);

}  // namespace boresight::plan
