// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/clear_sky.h"

#include "core/pointing/permitted_region.h"

#include <cmath>
#include <memory>

namespace boresight::profile {

std::function<bool(const SkyPointing&)> clearSky(const Profile& profile, const pointing::Antenna& antenna)
{
    const pointing::PointingModel model(profile.termsOf(antenna));
    const auto region = std::make_shared<const pointing::PermittedRegion>(
        profile.limits, profile.azimuth.geometry.travel, profile.elevation.geometry.travel, model);
    return [model, region](const SkyPointing& direction) {
        const AxisPosition axes = model.toAxes(direction).axes;
        const TravelRange& azimuths = region->ranges().azimuth;
        const auto firstTurn = static_cast<int>(std::ceil((azimuths.min - axes.azimuth).turns()));
        const auto lastTurn = static_cast<int>(std::floor((azimuths.max - axes.azimuth).turns()));
        for (int turn = firstTurn; turn <= lastTurn; ++turn) {
            const AxisPosition place{.azimuth = axes.azimuth + Angle::fromTurns(turn), .elevation = axes.elevation};
            if (region->permits(place)) {
                return true;
            }
        }
        return false;
    };
}

}  // namespace boresight::profile
