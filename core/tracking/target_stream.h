// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <array>
#include <deque>
#include <optional>

// Turns the points a client sends (Gpredict: `P` every 0.8…4 s in steps of its threshold) into a target that moves
// smoothly. While the points look like a path in the sky, the target follows that path and runs ahead of the last point
// for a bounded time: short, unless the client goes on reading the position and has nothing to object. Otherwise, and
// when the points cease, the target is the last point itself.
// Pure values, times are steady, any one thread. Bounds and measured errors: METHOD.md.
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
    // The next point of a client, already resolved to the turn of the axes it means. Times do not run backwards.
    void add(SteadyTime now, const AxisPosition& point);
    // A new target: whatever came before says nothing about it.
    void restart(SteadyTime now, const AxisPosition& point);
    void clear();
    // The client has read the position. Gpredict sends a point only while what it read is off by its threshold: one
    // that goes on reading and sends none is content with the path.
    void confirm(SteadyTime now);

    [[nodiscard]] std::optional<AxisPosition> lastPoint() const;  // empty before the first point
    [[nodiscard]] std::optional<MovingTarget> target(SteadyTime now) const;

private:
    using Vector = std::array<double, 3>;

    struct Point
    {
        SteadyTime time;
        AxisPosition position;
        Vector direction{};
    };

    // Straight through space, as a satellite flies by: direction = base + rate × (time since the last point).
    struct Path
    {
        Vector base{};
        Vector rate{};
        Seconds pause;  // between its points, on average
    };

    // How far ahead of the last point a path may be followed.
    struct Reach
    {
        Seconds run;
        Seconds wait;  // at the end of the run
        double angle;  // in the sky
    };

    [[nodiscard]] std::optional<Path> fittedPath() const;
    [[nodiscard]] double worstDeviation(const Path& path) const;
    void updatePath();
    [[nodiscard]] bool content(SteadyTime now) const;
    [[nodiscard]] Reach reachOf(const Path& path, SteadyTime now) const;
    [[nodiscard]] bool continues(SteadyTime now, const AxisPosition& point) const;

    std::deque<Point> m_points;  // oldest first
    std::optional<Path> m_path;
    std::optional<SteadyTime> m_confirmed;
    AxisPosition m_correction;  // from the present path to the one before, at the time of the last point
};

}  // namespace boresight::tracking
