// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/time_optimal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace boresight::tracking {

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

// Strings segments together until the duration is used up.
class Path
{
public:
    Path(const MotionState& now, double duration) : m_state(now), m_left(duration) {}

    void add(double duration, double acceleration)
    {
        const double used = std::min(duration, m_left);
        if (used > 0.0) {
            m_segments.push_back({.duration = used, .start = m_state, .acceleration = acceleration});
            m_state = m_segments.back().end();
            m_left -= used;
        }
    }
    // Goes on exactly from here: takes away the rounding of the segments before.
    void continueFrom(const MotionState& state) { m_state = state; }

    [[nodiscard]] double left() const { return m_left; }
    [[nodiscard]] std::vector<Segment> take() { return std::move(m_segments); }

private:
    std::vector<Segment> m_segments;
    MotionState m_state;
    double m_left;
};

}  // namespace

MotionState Segment::at(double time) const
{
    return {.position = start.position + time * (start.rate + 0.5 * acceleration * time),
            .rate = start.rate + acceleration * time};
}

double stopPosition(const MotionState& state, double acceleration)
{
    return state.position + state.rate * std::abs(state.rate) / (2.0 * acceleration);
}

std::vector<Segment> approach(const MotionState& now, const MotionState& target, const MotionBounds& bounds,
                              double duration)
{
    // As seen from the target, and mirrored so that the way leads upwards: `ahead` is the distance still to go,
    // `closing` how fast it shrinks. A stop now would end `passed` beyond the target if that is positive.
    const double a = bounds.acceleration;
    const MotionState relative{now.position - target.position, now.rate - target.rate};
    const double passed = stopPosition(relative, a);
    const double way = passed < 0.0 || (passed == 0.0 && relative.rate > 0.0) ? 1.0 : -1.0;
    const double ahead = -way * relative.position;
    const double closing = way * relative.rate;

    const double cap = bounds.speed - way * target.rate;
    const double peak = std::sqrt(std::max(0.0, 0.5 * closing * closing + a * ahead));
    const double cruise = std::max(0.0, std::min(peak, cap));
    const double accelerating = std::abs(cruise - closing) / a;
    const double covered = 0.5 * (closing + cruise) * accelerating;
    const double rest = std::max(0.0, ahead - covered - 0.5 * cruise * cruise / a);
    const double cruising = peak <= cap ? 0.0 : cruise > 0.0 ? rest / cruise : kForever;

    Path path(now, duration);
    path.add(accelerating, cruise >= closing ? way * a : -way * a);
    path.add(cruising, 0.0);
    path.add(cruise / a, -way * a);
    path.continueFrom({.position = target.position + target.rate * (duration - path.left()), .rate = target.rate});
    path.add(path.left(), 0.0);
    return path.take();
}

std::vector<Segment> changeRate(const MotionState& now, double rate, double acceleration, double duration)
{
    Path path(now, duration);
    const double changing = std::abs(rate - now.rate) / acceleration;
    path.add(changing, rate > now.rate ? acceleration : -acceleration);
    if (path.left() > 0.0) {
        const double position = now.position + 0.5 * (now.rate + rate) * changing;
        path.continueFrom({.position = position, .rate = rate});
        path.add(path.left(), 0.0);
    }
    return path.take();
}

}  // namespace boresight::tracking
