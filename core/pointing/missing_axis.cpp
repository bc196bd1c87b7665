// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/missing_axis.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace boresight::pointing {
namespace {

// Two halves that overlap, because a keep-out cannot span a full circle.
std::vector<KeepOut> atAllAzimuths(const std::vector<KeepOut>& keepOuts)
{
    std::vector<KeepOut> all;
    for (KeepOut keepOut : keepOuts) {
        for (const auto& [from, to] : {std::pair{0.0, 200.0}, std::pair{180.0, 20.0}}) {
            keepOut.azimuthFrom = Angle::fromDegrees(from);
            keepOut.azimuthTo = Angle::fromDegrees(to);
            all.push_back(keepOut);
        }
    }
    return all;
}

std::vector<HorizonPoint> highest(const std::vector<HorizonPoint>& horizon)
{
    if (horizon.empty()) {
        return {};
    }
    const auto top = std::ranges::max_element(horizon, {}, &HorizonPoint::elevation);
    return {{.azimuth = Angle{}, .elevation = top->elevation}};
}

}  // namespace

Region withoutAxis(Region region, Axis missing)
{
    if (missing == Axis::Azimuth) {
        region.azimuth = Region{}.azimuth;
        region.keepOuts = atAllAzimuths(region.keepOuts);
        region.horizon = highest(region.horizon);
        return region;
    }
    region.elevation = Region{}.elevation;
    region.horizon.clear();
    for (KeepOut& keepOut : region.keepOuts) {
        keepOut.elevationMin = Angle::fromDegrees(-90.0);
        keepOut.elevationMax = Angle::fromDegrees(90.0);
    }
    return region;
}

PointingTerms withoutAxis(const PointingTerms& terms, Axis missing)
{
    return missing == Axis::Azimuth
               ? PointingTerms{.elevationOffset = terms.elevationOffset, .elevationSag = terms.elevationSag}
               : PointingTerms{.azimuthOffset = terms.azimuthOffset};
}

// With a missing azimuth the nearest direction has the azimuth of the place. With a missing elevation the nearest
// elevation is where the great circle from the place meets the line from horizon to zenith at a right angle. If that is
// beyond an end of the line, it is this end.
Angle leastAngleBetween(const SkyPointing& beam, const SkyPointing& place, Axis missing)
{
    if (missing == Axis::Azimuth) {
        return abs(beam.elevation - place.elevation);
    }
    const Angle turn = abs((beam.azimuth - place.azimuth).wrapped180());
    if (turn >= 90_deg) {
        return 90_deg - abs(place.elevation);
    }
    return Angle::fromRadians(std::asin(std::sin(turn.radians()) * std::cos(place.elevation.radians())));
}

}  // namespace boresight::pointing
