// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/time_optimal.h"

#include <span>
#include <vector>

// The average of a motion over the last `length` seconds. Exact for segments of constant acceleration and ticks of any
// duration. The average stays inside the averaged motion, and its jerk is at most (largest - smallest acceleration) /
// length. Radians and seconds, pure.
namespace boresight::tracking {

class MovingAverage
{
public:
    struct Sample
    {
        double position = 0.0;
        double rate = 0.0;
        double acceleration = 0.0;
    };

    struct Extremes
    {
        double lowest = 0.0;
        double highest = 0.0;
    };

    // Starts with a motion that has always been at `position`.
    void reset(double position, double length);
    void append(std::span<const Segment> segments);

    [[nodiscard]] double length() const { return m_length; }
    [[nodiscard]] Sample sample() const;
    // The last appended motion, not averaged.
    [[nodiscard]] MotionState latest() const { return m_segments.back().end(); }
    [[nodiscard]] bool atRest() const;
    // The range of the average on its way to `stop`, where the motion stops without reversing again.
    [[nodiscard]] Extremes untilRestAt(double stop) const;

private:
    std::vector<Segment> m_segments;  // oldest first; the oldest may begin before the averaging window
    double m_length = 0.0;
};

}  // namespace boresight::tracking
