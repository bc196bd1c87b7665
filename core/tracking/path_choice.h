// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/point_path.h"

#include <array>
#include <cstddef>
#include <optional>

// Which path through the points of a client is followed. Exact points need a short path that bends with them. Points
// that are rounded, or come at uneven times, need a long one. So several paths are fitted, and the one that foretold
// the latest points best is followed. Pure value.
namespace boresight::tracking {

class PathChoice
{
public:
    static constexpr std::size_t kMostPoints = 28;  // of the longest path

    // Fits all paths through the points, oldest first.
    void fit(std::span<const Point> points);
    // The next point shows how well each path foretold it.
    void judge(const Point& next);
    void clear();
    // The last two points were far from where the path foretold them: the target moves on another path now.
    [[nodiscard]] bool hasTurned() const { return m_misses >= 2; }

    // The straight path through the last few points. Empty if there are too few.
    [[nodiscard]] const std::optional<PointPath>& straight() const { return m_paths.front().path; }
    // The root mean square of what the path to follow foretold wrong, in radians. Empty: it was not judged often
    // enough.
    [[nodiscard]] std::optional<double> foretold() const;
    // The path to follow.
    [[nodiscard]] const std::optional<PointPath>& best() const { return m_paths[m_best].path; }

private:
    struct Candidate
    {
        std::optional<PointPath> path;
        double error = 0.0;  // the mean square of what it foretold wrong, the latest points count most
        int judged = 0;      // points
    };

    std::array<Candidate, 4> m_paths;
    std::size_t m_best = 0;
    SteadyTime m_last;  // of the points
    int m_misses = 0;   // points in a row
};

}  // namespace boresight::tracking
