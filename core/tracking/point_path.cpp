// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/point_path.h"

#include <algorithm>
#include <cmath>

namespace boresight::tracking {

namespace {

// A bent path goes on straight after this time. Its bend is known too little for a longer time, in which no point came.
constexpr double kBendsFor = 4.0;  // s

}  // namespace

SpaceVector directionOf(const AxisPosition& position)
{
    const double horizontal = std::cos(position.elevation.radians());
    return {horizontal * std::cos(position.azimuth.radians()), horizontal * std::sin(position.azimuth.radians()),
            std::sin(position.elevation.radians())};
}

SpaceVector advanced(const SpaceVector& base, const SpaceVector& rate, double time)
{
    return {base[0] + rate[0] * time, base[1] + rate[1] * time, base[2] + rate[2] * time};
}

double distance(const SpaceVector& a, const SpaceVector& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

SpaceVector PointPath::at(double time) const
{
    const double bent = std::min(time, kBendsFor);
    return advanced(advanced(base, rate, time), bend, bent * (2.0 * time - bent));
}

SpaceVector PointPath::rateAt(double time) const
{
    return advanced(rate, bend, 2.0 * std::min(time, kBendsFor));
}

// By the polynomials 1, t - mean and (t - mean)² - skew (t - mean) - spread, which are orthogonal over the times. So
// each coefficient is a sum of its own.
PointPath fittedPath(std::span<const Point> points, Shape shape)
{
    const SteadyTime last = points.back().time;
    const auto timeOf = [last](const Point& point) { return Seconds(point.time - last).count(); };
    const auto count = static_cast<double>(points.size());
    double mean = 0.0;
    SpaceVector centre{};
    for (const Point& point : points) {
        mean += timeOf(point) / count;
        centre = advanced(centre, point.direction, 1.0 / count);
    }
    double squares = 0.0;
    double cubes = 0.0;
    SpaceVector rate{};
    for (const Point& point : points) {
        const double time = timeOf(point) - mean;
        squares += time * time;
        cubes += time * time * time;
        rate = advanced(rate, point.direction, time);
    }
    rate = advanced({}, rate, 1.0 / squares);
    SpaceVector bend{};
    const double skew = cubes / squares;
    const double spread = squares / count;
    if (shape == Shape::Bent) {
        double sum = 0.0;
        for (const Point& point : points) {
            const double time = timeOf(point) - mean;
            const double basis = time * time - skew * time - spread;
            sum += basis * basis;
            bend = advanced(bend, point.direction, basis);
        }
        bend = advanced({}, bend, 1.0 / sum);
    }
    // From the mean time to the time of the last point.
    return {.base = advanced(advanced(centre, rate, -mean), bend, mean * mean + skew * mean - spread),
            .rate = advanced(rate, bend, -2.0 * mean - skew),
            .bend = bend};
}

}  // namespace boresight::tracking
