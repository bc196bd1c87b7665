// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <array>
#include <span>

// A path through the last points of a client. Pure values.
namespace boresight::tracking {

using SpaceVector = std::array<double, 3>;

[[nodiscard]] SpaceVector directionOf(const AxisPosition& position);
[[nodiscard]] SpaceVector advanced(const SpaceVector& base, const SpaceVector& rate, double time);
// For directions of about unit length that are a few degrees apart, the chord equals the angle. Radians.
[[nodiscard]] double distance(const SpaceVector& a, const SpaceVector& b);

struct Point
{
    SteadyTime time;
    AxisPosition position;
    SpaceVector direction{};
};

enum class Shape
{
    Straight,  // direction = base + rate × time, like a satellite flying by
    Bent       // and bend × time²
};

// Times are since the last point, in seconds. The vectors are about as long as a direction.
struct PointPath
{
    SpaceVector base{};
    SpaceVector rate{};
    SpaceVector bend{};

    [[nodiscard]] SpaceVector at(double time) const;
    [[nodiscard]] SpaceVector rateAt(double time) const;
};

// The least squares of each component. Needs at least two points, for a bent path three, at different times.
[[nodiscard]] PointPath fittedPath(std::span<const Point> points, Shape shape);

}  // namespace boresight::tracking
