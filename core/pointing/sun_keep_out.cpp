// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/sun_keep_out.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace boresight::pointing {

namespace {

constexpr Angle kDown = Angle::fromDegrees(-2.0);

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
        // Where a circle of latitude touches the one around the Sun: sin(width) = sin(radius) / cos(elevation).
        const double width = std::sin(radius.radians()) / std::cos(sun.elevation.radians());
        const Angle half = Angle::fromRadians(std::asin(std::min(width, 1.0)));
        keepOut.azimuthFrom = (sun.azimuth - half).wrapped360();
        keepOut.azimuthTo = (sun.azimuth + half).wrapped360();
    }
    return keepOut;
}

Region withSun(const Region& drawn, const std::optional<KeepOut>& sun)
{
    Region region = drawn;
    if (sun) {
        region.keepOuts.push_back(*sun);
    }
    return region;
}

}  // namespace boresight::pointing
