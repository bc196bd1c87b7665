// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <deque>
#include <optional>

// Where a slowly changing value is heading: a least-squares line through the mean value of each second of the last
// minute. Pure.
namespace boresight::supervision {

class Trend
{
public:
    struct Line
    {
        double now = 0.0;  // the value of the line at the last point
        double perMinute = 0.0;

        // Time until the line reaches `limit`. Empty if the line leads away from it.
        [[nodiscard]] std::optional<Seconds> timeTo(double limit) const;
    };

    void add(SteadyTime at, double value);
    // Empty with less than 40 s of values, when the value hardly changes, and when the values do not lie along a line.
    // A supply under load changes in steps, and so does a temperature when a fan is switched on.
    [[nodiscard]] std::optional<Line> line() const;

private:
    struct Point
    {
        SteadyTime at{};
        double value = 0.0;
    };

    std::deque<Point> m_points;
    Point m_sum;  // sum of the running second, which began at `at`
    int m_count = 0;
};

}  // namespace boresight::supervision
