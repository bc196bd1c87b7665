// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/mount_model.h"
#include "core/profile/profile.h"
#include "core/targets/sky_moment.h"

#include <vector>

// Whether a mount can track a whole path, or must unwrap the cable in the middle of it. Computed as in the station: the
// wrap is chosen for the whole path. If no wrap has room, the mount turns back by 360° at the end of the cable. Pure,
// any thread.
namespace boresight::targets {

// The limits for one antenna on one mount.
struct MountReach
{
    pointing::MountModel model{{}, {}};  // within the ranges
    TravelRange azimuths;                // of travel and limits
    TravelRange elevations;
    tracking::MotionLimits turning;  // of the azimuth

    bool operator==(const MountReach& other) const;
};

[[nodiscard]] MountReach reachOf(const profile::Profile& profile, const pointing::Antenna& antenna);

struct CableTurns
{
    bool hasRoom = true;  // there is a wrap with room for the whole path
    bool hasGap = false;  // no wrap has room, because the mount turns less than 360°
    int turns = 0;        // how often the cable is unwrapped within the path
    // Longest time lost while the limits do not hide the target. Depends on where the mount comes from.
    Seconds lost{0.0};
    bool fitsOverTheTop = false;  // with elevations above 90° the mount would lose nothing

    bool operator==(const CableTurns&) const = default;
};

// The moments of the path must be a few seconds apart, as in passes.
[[nodiscard]] CableTurns cableTurns(const std::vector<SkyMoment>& way, const MountReach& reach);

}  // namespace boresight::targets
