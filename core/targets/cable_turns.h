// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/mount_model.h"
#include "core/profile/profile.h"
#include "core/targets/sky_moment.h"

#include <vector>

// Whether a mount tracks a way through the sky in one go, or has to turn back in the middle of it because its cable
// ends. As the station does it: the wrap is chosen for all of the way, and where none has room the mount turns back by
// 360° at the end of the cable. Pure, any thread.
namespace boresight::targets {

// Of one antenna on one mount.
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
    bool hasRoom = true;          // on one wrap, for all of the way
    bool hasGap = false;          // and there is none because the mount turns less than 360°
    int turns = 0;                // back, within the way
    Seconds lost{0.0};            // of what the limits do not hide, at most: it depends on where the mount comes from
    bool fitsOverTheTop = false;  // with elevations above 90° the mount would lose nothing

    bool operator==(const CableTurns&) const = default;
};

// Of a way whose moments are a few seconds apart, as they are in passes.
[[nodiscard]] CableTurns cableTurns(const std::vector<SkyMoment>& way, const MountReach& reach);

}  // namespace boresight::targets
