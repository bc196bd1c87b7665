// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/course.h"

#include <algorithm>

namespace boresight {
namespace {

constexpr int kMostSteps = 1000;
// Because of its ramps a way takes longer than its length at full speed.
constexpr int kStepsAtFullSpeed = 400;
constexpr Seconds kShortestStep{0.02};
constexpr Seconds kLongestStep{1.0};
constexpr Angle kThere = Angle::fromDegrees(1e-6);

Angle farther(const AxisPosition& a, const AxisPosition& b)
{
    return std::max(abs(b.azimuth - a.azimuth), abs(b.elevation - a.elevation));
}

// The time for all legs at full speed.
Seconds shortestTime(const Motion& motion, const AxisPosition& target)
{
    const auto alone = [&](Axis axis, Angle way) {
        return Seconds(abs(way).radians() / motion.limits(axis).speed.radians());
    };
    std::vector<AxisPosition> legs = motion.route();
    legs.push_back(target);
    AxisPosition from = motion.place();
    Seconds time{0.0};
    for (const AxisPosition& to : legs) {
        time += std::max(alone(Axis::Azimuth, to.azimuth - from.azimuth),
                         alone(Axis::Elevation, to.elevation - from.elevation));
        from = to;
    }
    return time;
}

bool isThere(const Motion& motion, const AxisPosition& target, SteadyTime now)
{
    const Angle left = farther(motion.place(), target);
    return motion.streaming(now) ? left < Course::kMet : motion.atRest() && left < kThere;
}

}  // namespace

std::optional<Course> Course::of(Motion motion, SteadyTime now)
{
    motion.keepOn(now);
    motion.setSeen(std::nullopt);  // the copy assumes that the rotator follows
    Course course;
    course.m_points.push_back({.place = motion.place()});
    // The set-points are exact for steps of any length. After the first step the route is known.
    Seconds step = kShortestStep;
    for (int i = 0; i < kMostSteps && motion.noWay().isEmpty(); ++i) {
        const Seconds after = course.duration();
        const SteadyTime then = now + std::chrono::round<SteadyTime::duration>(after);
        const auto target = motion.target(then);
        if (!target) {
            return std::nullopt;
        }
        if (isThere(motion, *target, then)) {
            return course;
        }
        if (i == 1) {
            step = std::clamp(shortestTime(motion, *target) / kStepsAtFullSpeed, kShortestStep, kLongestStep);
        }
        motion.advance(now + std::chrono::round<SteadyTime::duration>(after + step), step);
        course.m_points.push_back({.after = after + step, .place = motion.place()});
    }
    return std::nullopt;
}

AxisPosition Course::at(Seconds after) const
{
    const auto next = std::ranges::lower_bound(m_points, after, {}, &Point::after);
    if (next == m_points.begin()) {
        return m_points.front().place;
    }
    if (next == m_points.end()) {
        return end();
    }
    const Point& before = *std::prev(next);
    const double part = (after - before.after) / (next->after - before.after);
    return {.azimuth = before.place.azimuth + (next->place.azimuth - before.place.azimuth) * part,
            .elevation = before.place.elevation + (next->place.elevation - before.place.elevation) * part};
}

std::vector<AxisPosition> Course::rest(Seconds after, Angle step) const
{
    std::vector<AxisPosition> places;
    for (auto point = std::ranges::upper_bound(m_points, after, {}, &Point::after); point != m_points.end(); ++point) {
        if (places.empty() || std::next(point) == m_points.end() || farther(places.back(), point->place) >= step) {
            places.push_back(point->place);
        }
    }
    return places;
}

}  // namespace boresight
