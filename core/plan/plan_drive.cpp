// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/plan_drive.h"

#include "core/pointing/nearest_permitted.h"
#include "core/pointing/route.h"

#include <algorithm>
#include <cmath>

namespace boresight::plan {

using pointing::AxisBox;
using tracking::MotionState;

namespace {

// The rate of a path is computed from its points, so it may be slightly above the limit where a ramp has the limit.
constexpr double kAlmost = 1.02;

double mean(const MotionState& from, const MotionState& to, double time)
{
    return (to.position - from.position) / time;
}

bool keepsSpeed(const AxisStates& from, const AxisStates& to, double time, const PlanMount& mount)
{
    return std::abs(mean(from.azimuth, to.azimuth, time)) <= kAlmost * mount.azimuth.speed.radians() &&
           std::abs(mean(from.elevation, to.elevation, time)) <= kAlmost * mount.elevation.speed.radians();
}

AxisStates standing(const AxisPosition& place)
{
    return {.azimuth = {place.azimuth.radians(), 0.0}, .elevation = {place.elevation.radians(), 0.0}};
}

bool permits(const AxisStates& states, const PlanMount& mount)
{
    return mount.region.permits(onTheRim(states.place(), mount.region.ranges().elevation));
}

AxisStates permitted(const AxisStates& wanted, const PlanMount& mount)
{
    if (permits(wanted, mount)) {
        return wanted;
    }
    const auto place = nearestPermitted(mount.region, wanted.place());
    return place ? standing(*place) : wanted;
}

bool isNear(const AxisPosition& one, const AxisPosition& other)
{
    constexpr Angle kNear = Angle::fromDegrees(2.0);
    return abs(one.azimuth - other.azimuth) < kNear && abs(one.elevation - other.elevation) < kNear;
}

// Where to go now on the way to a goal. Short legs are left out: along a slope of the horizon the axes slide.
AxisPosition nextStop(const AxisPosition& now, const AxisPosition& goal, const PlanMount& mount)
{
    const AxisPosition from = mount.region.permits(now) ? now : nearestPermitted(mount.region, now).value_or(now);
    if (isNear(from, goal) || mount.region.permits(AxisBox::between(from, goal))) {
        return goal;
    }
    const AxisRates speed{.azimuth = mount.azimuth.speed, .elevation = mount.elevation.speed};
    const auto way = route(mount.region, from, goal, speed);
    if (!way) {
        return from;
    }
    const auto far = std::ranges::find_if(*way, [&](const AxisPosition& leg) { return !isNear(from, leg); });
    return far == way->end() ? goal : *far;
}

MotionState moved(const MotionState& now, const MotionState& target, const tracking::MotionLimits& limits, double time)
{
    const tracking::MotionBounds bounds = boundsOf(limits);
    const MotionState slower{target.position, std::clamp(target.rate, -bounds.speed, bounds.speed)};
    return tracking::approach(now, slower, bounds, time).segments().back().end();
}

}  // namespace

bool canFollow(const PassPath& path, const std::vector<AxisStates>& wanted, const PlanMount& mount)
{
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const bool isFastEnough =
            i == 0 || keepsSpeed(wanted[i - 1], wanted[i], path.points[i].seconds - path.points[i - 1].seconds, mount);
        if (!isFastEnough || !permits(wanted[i], mount)) {
            return false;
        }
    }
    return true;
}

std::vector<AxisStates> driven(const PassPath& path, const std::vector<AxisStates>& wanted, const PlanMount& mount)
{
    const TravelRange& elevations = mount.region.ranges().elevation;
    AxisStates before = permitted(wanted.front(), mount);
    std::vector<AxisStates> motion{before};
    for (std::size_t i = 1; i < wanted.size(); ++i) {
        const double time = path.points[i].seconds - path.points[i - 1].seconds;
        const AxisStates goal = permitted(wanted[i], mount);
        const AxisStates& now = motion.back();
        const AxisPosition there = onTheRim(goal.place(), elevations);
        const AxisPosition stop = nextStop(onTheRim(now.place(), elevations), there, mount);
        // A path that moves on is followed with its rate, so that the axes do not lag.
        const bool isPath = stop == there && keepsSpeed(before, goal, time, mount);
        const AxisStates target =
            isPath ? AxisStates{.azimuth = {before.azimuth.position, mean(before.azimuth, goal.azimuth, time)},
                                .elevation = {before.elevation.position, mean(before.elevation, goal.elevation, time)}}
                   : standing(stop);
        motion.push_back({.azimuth = moved(now.azimuth, target.azimuth, mount.azimuth, time),
                          .elevation = moved(now.elevation, target.elevation, mount.elevation, time)});
        before = goal;
    }
    return motion;
}

}  // namespace boresight::plan
