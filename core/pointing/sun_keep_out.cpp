// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/sun_keep_out.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace boresight::pointing {

namespace {

constexpr Angle kDown = Angle::fromDegrees(-2.0);

// The largest declination of the Sun is 23.44°. Refraction lifts it by at most 0.6°.
constexpr Angle kFarthest = Angle::fromDegrees(23.5 + 0.6);
// The band is divided into columns of azimuth and tested in steps of elevation. A step changes the declination by at
// most its own size. So a band that is one step wider, and one step longer at each end, misses nothing.
constexpr int kColumns = 24;
constexpr Angle kOverlap = Angle::fromDegrees(0.1);
constexpr Angle kStep = Angle::fromDegrees(0.5);

double cosine(Angle angle)
{
    return std::cos(angle.radians());
}

// True if the sine of the declination is within ±limit for any azimuth whose cosine is in the range, at this elevation.
bool isInBand(Angle latitude, Angle elevation, double leastCos, double mostCos, double limit)
{
    const double upright = std::sin(latitude.radians()) * std::sin(elevation.radians());
    const double across = std::cos(latitude.radians()) * std::cos(elevation.radians());
    return upright + across * leastCos <= limit && upright + across * mostCos >= -limit;
}

}  // namespace

std::optional<KeepOut> sunKeepOut(const SkyPointing& sun, Angle radius)
{
    if (sun.elevation < kDown) {
        return std::nullopt;
    }
    KeepOut keepOut{.name = Text::tr("Sun").toStdString(),
                    .azimuthFrom = 0_deg,
                    .azimuthTo = 360_deg,
                    .elevationMin = std::max(sun.elevation - radius, -90_deg),
                    .elevationMax = std::min(sun.elevation + radius, 90_deg)};
    if (sun.elevation + radius < 90_deg) {
        // Half width of the circle around the Sun in azimuth: sin(width) = sin(radius) / cos(elevation).
        const double width = std::sin(radius.radians()) / std::cos(sun.elevation.radians());
        const Angle half = Angle::fromRadians(std::asin(std::min(width, 1.0)));
        keepOut.azimuthFrom = (sun.azimuth - half).wrapped360();
        keepOut.azimuthTo = (sun.azimuth + half).wrapped360();
    }
    return keepOut;
}

std::vector<KeepOut> sunBand(Angle latitude, Angle radius)
{
    const double limit = std::sin(std::min(kFarthest + radius + kStep, 90_deg).radians());
    const Angle width = 360_deg / kColumns;
    const Angle lowest = std::max(kDown - radius, -90_deg);
    std::vector<KeepOut> band;
    for (int i = 0; i < kColumns; ++i) {
        const Angle from = i * width - kOverlap;
        const Angle to = (i + 1) * width + kOverlap;
        // The cosine has its extremes at 0° and 180°, which are borders of columns.
        const double least = to > 180_deg && from < 180_deg ? -1.0 : std::min(cosine(from), cosine(to));
        const double most = from < 0_deg || to > 360_deg ? 1.0 : std::max(cosine(from), cosine(to));
        bool before = false;
        for (Angle elevation = lowest; elevation < 90_deg + kStep; elevation += kStep) {
            const bool inside = isInBand(latitude, std::min(elevation, 90_deg), least, most, limit);
            if (inside && !before) {
                band.push_back({.name = Text::tr("Sun at any time: the clock is not synchronised").toStdString(),
                                .azimuthFrom = from.wrapped360(),
                                .azimuthTo = to.wrapped360(),
                                .elevationMin = std::max(elevation - kStep, -90_deg),
                                .elevationMax = {}});
            }
            if (inside) {
                band.back().elevationMax = std::min(elevation + kStep, 90_deg);
            }
            before = inside;
        }
    }
    return band;
}

Region withSun(const Region& drawn, const std::vector<KeepOut>& sun)
{
    Region region = drawn;
    region.keepOuts.insert(region.keepOuts.end(), sun.begin(), sun.end());
    return region;
}

}  // namespace boresight::pointing
