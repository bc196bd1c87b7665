// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/path_choice.h"
#include "core/tracking/stream_error.h"

#include <optional>
#include <vector>

// Turns the points of a client (Gpredict: `P` every 0.8…4 s in steps of its threshold) into a target that moves
// smoothly. While the points look like a path in the sky, the target follows that path and runs ahead of the last point
// for a limited time. The time is short, unless the client still reads the position without sending a point.
// Otherwise, and when no more points come, the target is the last point itself. Pure values, times are steady, any one
// thread. Limits and measured errors: METHOD.md.
namespace boresight::tracking {

// Where the target is and how it moves: the arguments of AxisSetpoints::follow for both axes.
struct MovingTarget
{
    AxisPosition position;
    AxisRates rates;
    bool streaming = false;  // true: follows a path (state TRACK); false: a fixed point (SLEW, HOLD)
};

class TargetStream
{
public:
    // The next point of a client, already on the turn of the axes that it means. Times must not decrease.
    void add(SteadyTime now, const AxisPosition& point);
    // A new target. Earlier points are forgotten.
    void restart(SteadyTime now, const AxisPosition& point);
    void clear();
    // The client has read the position. Gpredict sends a point only while the position that it read is off by its
    // threshold. So a client that reads but sends no point is content with the path.
    void confirm(SteadyTime now);

    [[nodiscard]] std::optional<AxisPosition> lastPoint() const;  // empty before the first point
    [[nodiscard]] std::optional<MovingTarget> target(SteadyTime now) const;
    // Empty while there is one point, and after the stream has ended.
    [[nodiscard]] std::optional<StreamError> error(SteadyTime now) const;

private:
    // How far the target may follow a path ahead of the last point.
    struct Reach
    {
        Seconds run;
        Seconds wait;  // time to wait at the end of the run
        double angle;  // on the sky
    };

    void updatePath();
    [[nodiscard]] bool areOnOnePath() const;
    [[nodiscard]] Seconds pause() const;
    [[nodiscard]] bool content(SteadyTime now) const;
    [[nodiscard]] Reach reachOf(const PointPath& path, SteadyTime now) const;
    [[nodiscard]] bool continues(SteadyTime now, const AxisPosition& point) const;

    std::vector<Point> m_points;  // oldest first
    PathChoice m_paths;
    std::optional<PointPath> m_path;  // that is followed
    std::optional<SteadyTime> m_confirmed;
    AxisPosition m_correction;  // from the present path to the previous one, at the time of the last point
};

}  // namespace boresight::tracking
