// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <deque>
#include <optional>

// Turns the points a client sends (Gpredict: `P` every 0.8…4 s in steps of its threshold) into a target that moves
// smoothly. While the points look like a path in the sky, the target follows that path and runs ahead of the last point
// for a short, bounded time; otherwise, and when the points cease, the target is the last point itself.
// Pure values, times are steady, any one thread. Bounds and measured errors: README.md.
namespace boresight::tracking {

// Where the target is now and how it moves: what AxisProfile::follow wants, for both axes.
struct MovingTarget
{
    AxisPosition position;
    AxisRates rates;
    bool streaming = false;  // follows a path (state TRACK) rather than a fixed point (SLEW, HOLD)
};

class TargetStream
{
public:
    // A new target: forgets everything before it.
    void restart(SteadyTime now, const AxisPosition& point);
    // The next point of a client, already resolved to the turn of the axes it means.
    void add(SteadyTime now, const AxisPosition& point);
    void clear() { m_points.clear(); }

    [[nodiscard]] std::optional<AxisPosition> lastPoint() const;  // empty before the first point
    [[nodiscard]] std::optional<MovingTarget> target(SteadyTime now) const;

private:
    struct Point
    {
        SteadyTime time;
        AxisPosition position;
    };
    std::deque<Point> m_points;
};

}  // namespace boresight::tracking
