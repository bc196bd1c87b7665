// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <deque>
#include <optional>

// Where a slowly changing value is heading: the least-squares line through its means of each second over the last
// minute. Pure.
namespace boresight::supervision {

class Trend
{
public:
    struct Line
    {
        double now = 0.0;  // on the line
        double perMinute = 0.0;

        // Until the line reaches `limit`; empty if it leads away from it.
        [[nodiscard]] std::optional<Seconds> timeTo(double limit) const;
    };

    void add(SteadyTime at, double value);
    // Empty with less than 40 s to judge from, and unless the values lie along a line: a supply under load and a fan
    // switched on change in steps.
    [[nodiscard]] std::optional<Line> line() const;

private:
    struct Point
    {
        SteadyTime at{};
        double value = 0.0;
    };

    std::deque<Point> m_points;
    Point m_sum;  // of the running second, which began at `at`
    int m_count = 0;
};

}  // namespace boresight::supervision
