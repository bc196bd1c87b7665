// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/pointing_model.h"

#include <cmath>
#include <random>

// Random pointing models and directions for tests. Many directions are near the zenith, the difficult part.
namespace boresight::fakes {

// Angle between two directions on the sky, in degrees. It is exact for small angles too.
inline double separation(const SkyPointing& a, const SkyPointing& b)
{
    const double ea = a.elevation.radians();
    const double eb = b.elevation.radians();
    const double turn = (b.azimuth - a.azimuth).radians();
    const double x = std::cos(ea) * std::sin(eb) - std::sin(ea) * std::cos(eb) * std::cos(turn);
    const double y = std::cos(eb) * std::sin(turn);
    const double z = std::sin(ea) * std::sin(eb) + std::cos(ea) * std::cos(eb) * std::cos(turn);
    return Angle::fromRadians(std::atan2(std::hypot(x, y), z)).degrees();
}

class RandomPointing
{
public:
    explicit RandomPointing(std::mt19937& random) : m_random(random) {}

    double uniform(double min, double max) { return std::uniform_real_distribution<double>(min, max)(m_random); }
    Angle degrees(double min, double max) { return Angle::fromDegrees(uniform(min, max)); }

    // With `size` 1: tilt up to 3°, collimation up to 2°, the rest up to 1°. From time to time a term is 0.
    pointing::PointingTerms terms(double size = 1.0)
    {
        const auto upTo = [&](double most) { return uniform(0, 4) < 1 ? Angle{} : degrees(-most * size, most * size); };
        return {.azimuthOffset = degrees(-360, 360),
                .elevationOffset = upTo(1),
                .tiltNorth = upTo(2.1),
                .tiltEast = upTo(2.1),
                .collimation = upTo(2),
                .nonPerpendicularity = upTo(1),
                .elevationSag = upTo(1)};
    }

    AxisPosition place() { return {.azimuth = degrees(-450, 450), .elevation = elevation()}; }
    SkyPointing direction() { return {.azimuth = degrees(-450, 450), .elevation = elevation()}; }

private:
    // A third each: from below the horizon over the top to below the horizon, within 5° of the zenith, within 1e-6° of
    // it.
    Angle elevation()
    {
        const double kind = uniform(0, 3);
        return kind < 1 ? degrees(-20, 200) : kind < 2 ? degrees(85, 95) : degrees(90 - 1e-6, 90 + 1e-6);
    }

    std::mt19937& m_random;
};

}  // namespace boresight::fakes
