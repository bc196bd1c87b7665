// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/pass_plan.h"
#include "core/plan/ramp.h"
#include "core/tracking/cable_room.h"

#include <optional>
#include <vector>

// One way through a pass that no wrap has been chosen for yet, and the variants of a plan that it gives. Pure.
namespace boresight::plan {

struct Course
{
    PlanWay way = PlanWay::Direct;
    std::vector<AxisStates> states;  // one for each point of the path
    std::optional<Ramp> ramp;
};

// Empty if the elevation does not reach that far, or if there is no ramp for it.
[[nodiscard]] std::optional<Course> courseOf(const PassPath& path, const Sides& sides, const PlanMount& mount);

// The wraps on which the cable has room for all of the course that is not hidden.
[[nodiscard]] tracking::WholeTurns wrapsOf(const PassPath& path, const Course& course, const PlanMount& mount);

// What all variants of a plan have in common.
struct PlanFrame
{
    const PassPath& path;
    const PlanMount& mount;
    AxisPosition now;  // of the axes
    Angle bound;       // of the error
};

// The course on a wrap.
[[nodiscard]] PlanVariant variantOf(const PlanFrame& frame, const Course& course, int wrap);

// If no wrap has room: on each wrap that has room for a part, the mount waits at the end of the cable. And it turns
// back by 360° at the moment at which the time lost is shortest, then where the target is lowest.
[[nodiscard]] std::vector<PlanVariant> splitsOf(const PlanFrame& frame, const Course& course);

}  // namespace boresight::plan
