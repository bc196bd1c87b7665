// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/state_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace boresight::plan {

using tracking::MotionState;
using Corners = std::vector<MotionState>;

namespace {

constexpr double kSame = 1e-12;     // two corners closer than this are one
constexpr double kOutside = 1e-10;  // a state this far outside counts as inside, because of rounding

MotionState plus(const MotionState& a, const MotionState& b, double factor)
{
    return {.position = a.position + factor * b.position, .rate = a.rate + factor * b.rate};
}

double cross(const MotionState& a, const MotionState& b)
{
    return a.position * b.rate - a.rate * b.position;
}

void append(Corners& corners, const MotionState& corner)
{
    if (corners.empty() || std::abs(corners.back().position - corner.position) > kSame ||
        std::abs(corners.back().rate - corner.rate) > kSame) {
        corners.push_back(corner);
    }
}

// The part of a polygon in which sign × value <= bound. `value` is the position or the rate.
Corners cut(const Corners& corners, double MotionState::*value, double sign, double bound)
{
    const auto beyond = [&](const MotionState& corner) { return sign * corner.*value - bound; };
    if (std::ranges::none_of(corners, [&](const MotionState& corner) { return beyond(corner) > 0.0; })) {
        return corners;
    }
    Corners kept;
    kept.reserve(corners.size() + 2);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const MotionState& here = corners[i];
        const MotionState& next = corners[(i + 1) % corners.size()];
        const double a = beyond(here);
        const double b = beyond(next);
        if (a <= 0.0) {
            append(kept, here);
        }
        if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)) {
            MotionState edge = plus(here, plus(next, here, -1.0), a / (a - b));
            edge.*value = sign * bound;
            append(kept, edge);
        }
    }
    return kept;
}

// The point of the line between two states that is closest to another state.
MotionState closestOnEdge(const MotionState& a, const MotionState& b, const MotionState& wish, double time)
{
    const MotionState along = plus(b, a, -1.0);
    const MotionState to = plus(wish, a, -1.0);
    const double square = along.position * along.position + time * time * along.rate * along.rate;
    const double part = along.position * to.position + time * time * along.rate * to.rate;
    return plus(a, along, square > 0.0 ? std::clamp(part / square, 0.0, 1.0) : 0.0);
}

}  // namespace

StateSet StateSet::only(const MotionState& state)
{
    return StateSet({state});
}

StateSet StateSet::box(double low, double high, double speed)
{
    return StateSet({{low, -speed}, {high, -speed}, {high, speed}, {low, speed}});
}

bool StateSet::contains(const MotionState& state) const
{
    const std::size_t count = m_corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const MotionState along = plus(m_corners[(i + 1) % count], m_corners[i], -1.0);
        const double length = std::hypot(along.position, along.rate);
        if (cross(along, plus(state, m_corners[i], -1.0)) < -kOutside * std::max(length, kSame)) {
            return false;
        }
    }
    return count > 2;
}

// The sum of the polygon, which time has sheared, and the line of what the accelerations add.
StateSet StateSet::later(double time, double acceleration) const
{
    const MotionState added{.position = 0.5 * acceleration * time * time, .rate = acceleration * time};
    Corners sheared = m_corners;
    std::vector<double> sides;
    sides.reserve(sheared.size());
    for (MotionState& corner : sheared) {
        corner.position += corner.rate * time;
        sides.push_back(cross(added, corner));
    }
    const auto rightmost = static_cast<std::size_t>(std::ranges::min_element(sides) - sides.begin());
    const auto leftmost = static_cast<std::size_t>(std::ranges::max_element(sides) - sides.begin());
    const std::size_t count = sheared.size();
    Corners grown;
    grown.reserve(count + 2);
    for (std::size_t i = rightmost;; i = (i + 1) % count) {
        append(grown, plus(sheared[i], added, 1.0));
        if (i == leftmost) {
            break;
        }
    }
    for (std::size_t i = leftmost;; i = (i + 1) % count) {
        append(grown, plus(sheared[i], added, -1.0));
        if (i == rightmost) {
            break;
        }
    }
    return StateSet(std::move(grown));
}

StateSet StateSet::within(double low, double high, double speed) const
{
    Corners kept = cut(m_corners, &MotionState::position, 1.0, high);
    kept = cut(kept, &MotionState::position, -1.0, -low);
    kept = cut(kept, &MotionState::rate, 1.0, speed);
    return StateSet(cut(kept, &MotionState::rate, -1.0, speed));
}

MotionState StateSet::closest(const MotionState& wish, double time) const
{
    if (contains(wish)) {
        return wish;
    }
    MotionState best = m_corners.front();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        const MotionState here = closestOnEdge(m_corners[i], m_corners[(i + 1) % m_corners.size()], wish, time);
        const double distance = std::hypot(here.position - wish.position, time * (here.rate - wish.rate));
        if (distance < least) {
            least = distance;
            best = here;
        }
    }
    return best;
}

MotionState StateSet::before(const MotionState& to, double time, double acceleration, const MotionState& wish) const
{
    // The states that lead to `to` are a line: start + u × along, where u is the acceleration.
    const MotionState start{.position = to.position - to.rate * time, .rate = to.rate};
    const MotionState along{.position = 0.5 * time * time, .rate = -time};
    double from = -acceleration;
    double until = acceleration;
    const std::size_t count = m_corners.size();
    for (std::size_t i = 0; count > 1 && i < count; ++i) {
        const MotionState edge = plus(m_corners[(i + 1) % count], m_corners[i], -1.0);
        const double inside =
            cross(edge, plus(start, m_corners[i], -1.0)) + kOutside * std::hypot(edge.position, edge.rate);
        const double slope = cross(edge, along);
        if (slope > 0.0) {
            from = std::max(from, -inside / slope);
        } else if (slope < 0.0) {
            until = std::min(until, -inside / slope);
        }
    }
    if (count == 1) {
        return m_corners.front();
    }
    if (from > until) {  // by rounding
        from = until = std::clamp(0.5 * (from + until), -acceleration, acceleration);
    }
    return closestOnEdge(plus(start, along, from), plus(start, along, until), wish, time);
}

}  // namespace boresight::plan
