// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognise/sent_points.h"

#include <algorithm>
#include <cmath>

namespace boresight::recognise {
namespace {

constexpr Angle kSamePlace = 0.02_deg;
constexpr Angle kAtHorizon = 0.5_deg;
constexpr Angle kShortestTravel = 0.3_deg;
// Gpredict aims ahead by its threshold, which is half of the distance between its points. A little more is permitted,
// because its points are not sent at once.
constexpr double kLeadPart = 0.6;
// Gpredict's default threshold of 5°, and the same little more.
constexpr Angle kLongestLead = 6.0_deg;

bool isMultiple(Angle angle, double step)
{
    constexpr double kRest = 1e-4;  // degrees: single precision of 360°
    const double steps = angle.degrees() / step;
    return std::abs(steps - std::round(steps)) * step < kRest;
}

}  // namespace

orbit::Vector unitOf(const SkyPointing& direction)
{
    const double level = std::cos(direction.elevation.radians());
    return {level * std::sin(direction.azimuth.radians()), level * std::cos(direction.azimuth.radians()),
            std::sin(direction.elevation.radians())};
}

// Exact for small angles, too.
Angle angleBetween(const orbit::Vector& a, const orbit::Vector& b)
{
    return 2.0 * Angle::fromRadians(std::asin(std::min(1.0, 0.5 * length(b - a))));
}

Angle travelOf(const SentPoints& points)
{
    return points.empty() ? Angle{} : angleBetween(unitOf(points.front().direction), unitOf(points.back().direction));
}

Angle leadOf(const SentPoints& points)
{
    Angle longest;
    for (std::size_t i = 1; i < points.size(); ++i) {
        longest = std::max(longest, angleBetween(unitOf(points[i - 1].direction), unitOf(points[i].direction)));
    }
    return std::min(kLeadPart * longest, kLongestLead);
}

Angle stepOf(const SentPoints& points)
{
    for (const double step : {1.0, 0.1}) {
        if (std::ranges::all_of(points, [step](const SentPoint& point) {
                return isMultiple(point.direction.azimuth, step) && isMultiple(point.direction.elevation, step);
            })) {
            return Angle::fromDegrees(step);
        }
    }
    return 0.01_deg;
}

bool waitsAtHorizon(const SentPoints& points)
{
    return !points.empty() && std::ranges::all_of(points, [&](const SentPoint& point) {
        return abs(point.direction.elevation) <= kAtHorizon &&
               angleBetween(unitOf(point.direction), unitOf(points.front().direction)) <= kSamePlace;
    });
}

bool showsMotion(const SentPoints& points)
{
    return travelOf(points) >= kShortestTravel;
}

}  // namespace boresight::recognise
