// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/pass_path.h"

#include <optional>
#include <vector>

// The way through the keyhole: how the axes pass the part of a path in which the target is faster than they are. The
// largest pointing error is the least possible one within speed and acceleration (README.md has the method). The axes
// leave the target early, pass its azimuth of the highest point on the way, and are back on the target later. Pure.
namespace boresight::plan {

// On which half turn the axes follow the target before and after the keyhole. An odd number means over the top.
struct Sides
{
    int before = 0;
    int after = 0;

    bool operator==(const Sides&) const = default;
};

struct Ramp
{
    std::size_t begin = 0;           // the first point of `states`
    std::vector<AxisStates> states;  // one for each point
    std::size_t leaves = 0;          // the point at which the azimuth leaves the target
    std::size_t returns = 0;         // and is back
};

// Empty if there is no such way, or if the path has no fast part.
[[nodiscard]] std::optional<Ramp> bestRamp(const PassPath& path, const Sides& sides, const PlanMount& mount);

}  // namespace boresight::plan
