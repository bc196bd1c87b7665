// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/missing_axis.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace boresight::pointing {
namespace {

// Two halves that overlap: a keep-out ends where it begins at the latest.
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

}  // namespace boresight::pointing
