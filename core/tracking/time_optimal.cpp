// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/time_optimal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace boresight::tracking {

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

// Joins segments until the duration is used up.
class PathBuilder
{
public:
    PathBuilder(const MotionState& now, double duration) : m_state(now), m_left(duration) {}

    void add(double duration, double acceleration)
    {
        const double used = std::min(duration, m_left);
        if (used > 0.0) {
            const Segment segment{.duration = used, .start = m_state, .acceleration = acceleration};
            m_path.add(segment);
            m_state = segment.end();
            m_left -= used;
        }
    }
    // Continues exactly from this state, which removes the rounding of the previous segments.
    void continueFrom(const MotionState& state) { m_state = state; }

    [[nodiscard]] double left() const { return m_left; }
    [[nodiscard]] const Path& path() const { return m_path; }

private:
    Path m_path;
    MotionState m_state;
    double m_left;
};

// The target as seen from the motion, mirrored so that the way leads upwards: `ahead` is the remaining distance,
// `closing` the speed at which it shrinks. If an immediate stop would end beyond the target, the way leads back.
struct Ahead
{
    double way = 1.0;  // or -1
    double ahead = 0.0;
    double closing = 0.0;

    // The peak speed of a way without a phase of constant speed.
    [[nodiscard]] double peak(double acceleration) const
    {
        return std::sqrt(std::max(0.0, 0.5 * closing * closing + acceleration * ahead));
    }
};

Ahead lookAhead(const MotionState& relative, double acceleration)
{
    const double passed = stopPosition(relative, acceleration);
    const double way = passed < 0.0 || (passed == 0.0 && relative.rate > 0.0) ? 1.0 : -1.0;
    return {.way = way, .ahead = -way * relative.position, .closing = way * relative.rate};
}

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

Path approach(const MotionState& now, const MotionState& target, const MotionBounds& bounds, double duration)
{
    const double a = bounds.acceleration;
    const Ahead to = lookAhead({now.position - target.position, now.rate - target.rate}, a);
    const double cap = bounds.speed - to.way * target.rate;
    const double peak = to.peak(a);
    const double cruise = std::max(0.0, std::min(peak, cap));
    const double accelerating = std::abs(cruise - to.closing) / a;
    const double covered = 0.5 * (to.closing + cruise) * accelerating;
    const double rest = std::max(0.0, to.ahead - covered - 0.5 * cruise * cruise / a);
    const double cruising = peak <= cap ? 0.0 : cruise > 0.0 ? rest / cruise : kForever;

    PathBuilder path(now, duration);
    path.add(accelerating, cruise >= to.closing ? to.way * a : -to.way * a);
    path.add(cruising, 0.0);
    path.add(cruise / a, -to.way * a);
    path.continueFrom({.position = target.position + target.rate * (duration - path.left()), .rate = target.rate});
    path.add(path.left(), 0.0);
    return path.path();
}

double restTime(const MotionState& now, double position, const MotionBounds& bounds)
{
    const double a = bounds.acceleration;
    const Ahead to = lookAhead({now.position - position, now.rate}, a);
    const double peak = to.peak(a);
    const double cruise = std::min(peak, bounds.speed);
    if (cruise <= 0.0) {
        return 0.0;
    }
    const double accelerating = std::abs(cruise - to.closing) / a;
    const double rest = to.ahead - 0.5 * (to.closing + cruise) * accelerating - 0.5 * cruise * cruise / a;
    return accelerating + std::max(0.0, rest) / cruise + cruise / a;
}

// The duration of a way decreases with its cruise speed v. From closing speed c over the distance d it takes (v - c) /
// a + (d - (2 v² - c²) / 2a) / v + v / a, or c / a + (d - c² / 2a) / v if it first slows down to v. This function
// solves it for v.
double speedForRestTime(const MotionState& now, double position, const MotionBounds& bounds, double time)
{
    const double a = bounds.acceleration;
    const Ahead to = lookAhead({now.position - position, now.rate}, a);
    const double stopping = 0.5 * to.closing * to.closing / a;
    const double sum = time + to.closing / a;
    const double root = sum * sum - 4.0 * (to.ahead + stopping) / a;
    if (root <= 0.0) {
        return bounds.speed;  // the axis cannot arrive that early
    }
    double speed = 0.5 * a * (sum - std::sqrt(root));
    if (speed < to.closing) {
        const double left = time - to.closing / a;
        speed = left > 0.0 ? (to.ahead - stopping) / left : bounds.speed;
    }
    constexpr double kLeast = 1e-6;
    return std::clamp(speed, kLeast * bounds.speed, bounds.speed);
}

Path changeRate(const MotionState& now, double rate, double acceleration, double duration)
{
    PathBuilder path(now, duration);
    const double changing = std::abs(rate - now.rate) / acceleration;
    path.add(changing, rate > now.rate ? acceleration : -acceleration);
    if (path.left() > 0.0) {
        const double position = now.position + 0.5 * (now.rate + rate) * changing;
        path.continueFrom({.position = position, .rate = rate});
        path.add(path.left(), 0.0);
    }
    return path.path();
}

}  // namespace boresight::tracking
