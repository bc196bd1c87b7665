// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/motion/motion.h"
#include "core/units/sky.h"

#include <optional>
#include <vector>

// The way that the set-points will take to where they are sent, and when they are where: found by moving a copy of the
// motion on, so route, limits, speed, acceleration and jerk count as they will. Pure; a look costs as much as 1,000
// ticks at most. Mechanical angles.
namespace boresight {

class Course
{
public:
    // Of `motion` from `now` on. A stream is taken to go on straight, and met within kMet. Empty when the motion goes
    // to no target, or does not get there.
    [[nodiscard]] static std::optional<Course> of(Motion motion, SteadyTime now);

    static constexpr Angle kMet = Angle::fromDegrees(1.0);

    [[nodiscard]] Seconds duration() const { return m_points.back().after; }
    [[nodiscard]] AxisPosition at(Seconds after) const;
    [[nodiscard]] const AxisPosition& end() const { return m_points.back().place; }
    // What is left of it then, in steps of about `step`, its end included.
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
