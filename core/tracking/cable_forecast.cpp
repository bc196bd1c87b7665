// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/cable_forecast.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace boresight::tracking {
namespace {

using Vector = std::array<double, 3>;  // north, east, up

constexpr int kSteps = 180;  // of one degree along the great circle: half of the sky
constexpr Angle kStep = Angle::fromDegrees(1.0);
// A quarter of the rate of the stars. A slower target counts as fixed, with some jitter.
constexpr AngularRate kStanding = AngularRate::fromDegrees(0.001);

struct Course
{
    Vector direction;
    Vector ahead;  // 90° farther on the great circle
    AngularRate rate;
};

std::optional<Course> courseOf(const MovingTarget& target)
{
    const double az = target.position.azimuth.radians();
    const double el = target.position.elevation.radians();
    const double azRate = target.rates.azimuth.radians() * std::cos(el);
    const double elRate = target.rates.elevation.radians();
    const AngularRate rate = AngularRate::fromRadians(std::hypot(azRate, elRate));
    if (rate < kStanding) {
        return std::nullopt;
    }
    const Vector east{-std::sin(az), std::cos(az), 0.0};
    const Vector up{-std::sin(el) * std::cos(az), -std::sin(el) * std::sin(az), std::cos(el)};
    Course course{.direction = {std::cos(el) * std::cos(az), std::cos(el) * std::sin(az), std::sin(el)},
                  .ahead = {},
                  .rate = rate};
    for (std::size_t i = 0; i < course.ahead.size(); ++i) {
        course.ahead[i] = (azRate * east[i] + elRate * up[i]) / rate.radians();
    }
    return course;
}

Vector along(const Course& course, Angle way)
{
    Vector direction{};
    for (std::size_t i = 0; i < direction.size(); ++i) {
        direction[i] = course.direction[i] * std::cos(way.radians()) + course.ahead[i] * std::sin(way.radians());
    }
    return direction;
}

Angle azimuthOf(const Vector& direction)
{
    return Angle::fromRadians(std::atan2(direction[1], direction[0]));
}

// The part of the way between the two azimuths that is outside the range, 0 to 1.
double partBeyond(Angle from, Angle to, const TravelRange& azimuths)
{
    const auto [low, high] = std::minmax(from, to);
    if (low == high) {
        return azimuths.contains(low) ? 0.0 : 1.0;
    }
    const Angle inside = std::min(high, azimuths.max) - std::max(low, azimuths.min);
    return 1.0 - std::max(inside, Angle{}) / (high - low);
}

}  // namespace

std::optional<CableForecast> forecastCableEnd(const MovingTarget& target, const TravelRange& azimuths)
{
    const auto course = courseOf(target);
    if (!course || !azimuths.contains(target.position.azimuth)) {
        return std::nullopt;
    }
    Angle azimuth = target.position.azimuth;
    Vector direction = course->direction;
    for (int step = 1; step <= kSteps; ++step) {
        const Vector next = along(*course, kStep * step);
        if (next[2] < 0.0) {
            return std::nullopt;
        }
        const Angle turned = (azimuthOf(next) - azimuthOf(direction)).wrapped180();
        const Angle end = turned > Angle() ? azimuths.max : azimuths.min;
        if (!azimuths.contains(azimuth + turned)) {
            const double part = (end - azimuth) / turned;
            return CableForecast{.end = end,
                                 .in = Seconds((kStep * (step - 1 + part)).radians() / course->rate.radians()),
                                 .left = abs(end - target.position.azimuth)};
        }
        azimuth = azimuth + turned;
        direction = next;
    }
    return std::nullopt;
}

Seconds timeBeyond(const std::vector<PathMoment>& path, const TravelRange& azimuths)
{
    Seconds lost{};
    for (std::size_t i = 1; i < path.size(); ++i) {
        const PathMoment& from = path[i - 1];
        const PathMoment& to = path[i];
        if (from.isReachable && to.isReachable) {
            lost += (to.in - from.in) * partBeyond(from.azimuth, to.azimuth, azimuths);
        }
    }
    return lost;
}

}  // namespace boresight::tracking
