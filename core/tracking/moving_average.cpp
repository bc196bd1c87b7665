// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/moving_average.h"

#include <algorithm>

namespace boresight::tracking {

namespace {

// Integral of the position relative to `origin`, from `begin` to the end of the segment.
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
    double newer = 0.0;  // duration of the segments after the present one
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

// If the motion never reversed, the average goes straight to the stop. If it reversed once, the average reverses at
// most once and stays inside the motion. If it reversed more often, it is only certain that the average stays inside
// the motion.
MovingAverage::Extremes MovingAverage::untilRestAt(double stop) const
{
    const double now = sample().position;
    Extremes motion{.lowest = latest().position, .highest = latest().position};
    int turns = 0;
    double way = 0.0;  // the sign of the last nonzero rate
    const auto look = [&](const MotionState& state) {
        motion = {std::min(motion.lowest, state.position), std::max(motion.highest, state.position)};
        if (state.rate != 0.0) {
            turns += way * state.rate < 0.0 ? 1 : 0;
            way = state.rate > 0.0 ? 1.0 : -1.0;
        }
    };
    for (const Segment& segment : m_segments) {
        look(segment.start);
        if (segment.start.rate * segment.end().rate < 0.0) {
            look(segment.at(-segment.start.rate / segment.acceleration));
        }
        look(segment.end());
    }
    Extremes straight{.lowest = std::min(now, stop), .highest = std::max(now, stop)};
    if (turns > 1 || (turns == 1 && way > 0.0)) {
        straight.lowest = std::min(straight.lowest, motion.lowest);
    }
    if (turns > 1 || (turns == 1 && way < 0.0)) {
        straight.highest = std::max(straight.highest, motion.highest);
    }
    return straight;
}

}  // namespace boresight::tracking
