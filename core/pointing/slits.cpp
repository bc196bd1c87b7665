// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/slits.h"

#include "core/pointing/ranges.h"

#include <algorithm>

namespace boresight::pointing {

namespace {

const Angle kTouching = Angle::fromDegrees(1e-6);

// The part of a line of the horizon that is at or above `height`. min > max if no part is.
TravelRange partAbove(const HorizonPoint& from, const HorizonPoint& to, Angle height)
{
    if (from.elevation < height && to.elevation < height) {
        return {.min = to.azimuth, .max = from.azimuth};
    }
    TravelRange part{from.azimuth, to.azimuth};
    const double crossing = (height - from.elevation) / (to.elevation - from.elevation);
    if (from.elevation < height) {
        part.min = from.azimuth + crossing * (to.azimuth - from.azimuth);
    } else if (to.elevation < height) {
        part.max = from.azimuth + crossing * (to.azimuth - from.azimuth);
    }
    return part;
}

}  // namespace

std::vector<KeepOut> standingOnHorizon(const KeepOut& keepOut, const Skyline& skyline)
{
    const Angle width = keepOut.azimuthTo < keepOut.azimuthFrom ? keepOut.azimuthTo - keepOut.azimuthFrom + kFullTurn
                                                                : keepOut.azimuthTo - keepOut.azimuthFrom;
    const TravelRange whole{keepOut.azimuthFrom, keepOut.azimuthFrom + width};
    std::vector<TravelRange> parts;
    for (const Angle turn : {-kFullTurn, 0_deg, kFullTurn}) {
        for (std::size_t i = 0; i < skyline.lineCount(); ++i) {
            const auto [from, to] = skyline.line(i);
            const TravelRange part = partAbove({from.azimuth + turn, from.elevation}, {to.azimuth + turn, to.elevation},
                                               keepOut.elevationMin - kSlit);
            const TravelRange inside{std::max(part.min, whole.min), std::min(part.max, whole.max)};
            if (inside.min > inside.max) {
                continue;
            }
            if (!parts.empty() && inside.min - parts.back().max <= kTouching) {
                parts.back().max = std::max(parts.back().max, inside.max);
            } else {
                parts.push_back(inside);
            }
        }
    }
    std::vector<KeepOut> standing;
    for (const TravelRange& part : parts) {
        standing.push_back(keepOut);
        standing.back().azimuthFrom = part.min;
        standing.back().azimuthTo = part.max;
        standing.back().elevationMin = -90_deg;
    }
    return standing;
}

}  // namespace boresight::pointing
