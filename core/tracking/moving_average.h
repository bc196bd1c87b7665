// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/time_optimal.h"

#include <span>
#include <vector>

// The average of a motion over the last `length` seconds, exact for segments of constant acceleration and ticks of any
// length. An average never leaves what it averages over, and its acceleration changes no faster than
// (largest - smallest acceleration) / length. Radians and seconds, pure.
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

    // As if the motion had rested at `position` for ever.
    void reset(double position, double length);
    void append(std::span<const Segment> segments);

    [[nodiscard]] double length() const { return m_length; }
    [[nodiscard]] Sample sample() const;
    // The motion as it was last appended, not averaged.
    [[nodiscard]] MotionState latest() const { return m_segments.back().end(); }
    [[nodiscard]] bool atRest() const;
    // Between which bounds the average stays on its way to `stop`, where the motion comes to rest without turning
    // again.
    [[nodiscard]] Extremes untilRestAt(double stop) const;

private:
    std::vector<Segment> m_segments;  // oldest first; the oldest may begin before the averaging does
    double m_length = 0.0;
};

}  // namespace boresight::tracking
