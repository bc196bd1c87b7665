// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/motion/motion.h"
#include "core/units/sky.h"

#include <optional>
#include <vector>

// The way of the set-points to their target, with times. It is computed by moving a copy of the motion on, so route,
// limits, speed, acceleration and jerk count as in the real motion. Pure. One computation costs at most as much as
// 1,000 ticks. Mechanical angles.
namespace boresight {

class Course
{
public:
    // The course of `motion` from `now` on. A stream is assumed to go on straight, and counts as reached within kMet.
    // Empty if the motion has no target or does not reach it.
    [[nodiscard]] static std::optional<Course> of(Motion motion, SteadyTime now);

    static constexpr Angle kMet = Angle::fromDegrees(1.0);

    [[nodiscard]] Seconds duration() const { return m_points.back().after; }
    [[nodiscard]] AxisPosition at(Seconds after) const;
    [[nodiscard]] const AxisPosition& end() const { return m_points.back().place; }
    // The rest of the course from the time `after`, in steps of about `step`, with its end.
    [[nodiscard]] std::vector<AxisPosition> rest(Seconds after, Angle step) const;

private:
    struct Point
    {
        Seconds after{0.0};
        AxisPosition place;
    };

    Course() = default;

    std::vector<Point> m_points;
};

}  // namespace boresight
