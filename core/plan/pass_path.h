// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/plan/plan_mount.h"
#include "core/tracking/time_optimal.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

// The path of a target during a pass, as angles of the axes of one mount: upright, unwrapped, with rates. The points
// are close together where the axes are too slow for the target. Pure, any thread.
namespace boresight::plan {

// The direction of the target. Empty: the orbit has no answer.
using DirectionAt = std::function<std::optional<SkyPointing>(UtcTime)>;

// Both axes at one moment, in radians.
struct AxisStates
{
    tracking::MotionState azimuth;
    tracking::MotionState elevation;

    [[nodiscard]] AxisPosition place() const;
};

struct PathPoint
{
    UtcTime utc{};
    double seconds = 0.0;  // after the first point
    SkyPointing direction{};
    AxisStates axes{};        // upright
    AxisStates overTheTop{};  // half a turn further
    bool isHidden = false;    // by limits, horizon or keep-outs, on every wrap, upright and over the top
};

// The part of the path in which the target is faster than the axes, as indices of points.
struct FastPart
{
    std::size_t first = 0;  // the target is too fast from here
    std::size_t last = 0;   // to here
    std::size_t begin = 0;  // a ramp does not begin earlier
    std::size_t end = 0;    // and does not end later
};

struct PassPath
{
    std::vector<PathPoint> points;
    std::optional<FastPart> fast;

    // The index of the highest point.
    [[nodiscard]] std::size_t top() const;
};

// Ends early where the orbit has no answer. May be empty.
[[nodiscard]] PassPath pathOf(const DirectionAt& directionAt, UtcTime from, UtcTime to, const PlanMount& mount);

// The axes turned by this number of half turns. They point in the same direction: with an odd number over the top.
[[nodiscard]] AxisStates turned(const PathPoint& point, int halfTurns);

}  // namespace boresight::plan
