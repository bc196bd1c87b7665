// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/moving_average.h"

#include <algorithm>

namespace boresight::tracking {

namespace {

// Of the position relative to `origin`, from `begin` to the end of the segment.
double integral(const Segment& segment, double begin, double origin)
{
    const MotionState from = segment.at(begin);
    const double time = segment.duration - begin;
    return time * ((from.position - origin) + time * (0.5 * from.rate + time * segment.acceleration / 6.0));
}

}  // namespace

void MovingAverage::reset(double position, double length)
{
    m_length = length;
    m_segments.assign(1, Segment{.duration = length, .start = {.position = position, .rate = 0.0}});
}

void MovingAverage::append(std::span<const Segment> segments)
{
    m_segments.insert(m_segments.end(), segments.begin(), segments.end());
    double newer = 0.0;  // than the segment in hand
    auto oldest = m_segments.end();
    while (oldest != m_segments.begin() && newer < m_length) {
        --oldest;
        newer += oldest->duration;
    }
    m_segments.erase(m_segments.begin(), oldest);
}

MovingAverage::Sample MovingAverage::sample() const
{
    const MotionState now = latest();
    double sum = 0.0;
    double left = m_length;
    MotionState oldest = now;
    for (auto segment = m_segments.rbegin(); segment != m_segments.rend() && left > 0.0; ++segment) {
        const double begin = std::max(0.0, segment->duration - left);
        sum += integral(*segment, begin, now.position);
        oldest = segment->at(begin);
        left -= segment->duration - begin;
    }
    return {.position = now.position + sum / m_length,
            .rate = (now.position - oldest.position) / m_length,
            .acceleration = (now.rate - oldest.rate) / m_length};
}

bool MovingAverage::atRest() const
{
    return std::all_of(m_segments.begin(), m_segments.end(), [](const Segment& segment) { return segment.atRest(); });
}

}  // namespace boresight::tracking
