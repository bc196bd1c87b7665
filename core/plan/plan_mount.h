// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/pointing/permitted_region.h"
#include "core/profile/profile.h"
#include "core/tracking/axis_setpoints.h"
#include "core/tracking/time_optimal.h"

// What a plan needs of a mount: where its axes may be, how fast they are, and how wide the beam is. Pure, any thread.
namespace boresight::plan {

struct PlanMount
{
    pointing::PermittedRegion region;
    pointing::PointingModel pointing;
    tracking::MotionLimits azimuth;
    tracking::MotionLimits elevation;
    Angle beamWidth = Angle::fromDegrees(10.0);  // half-power
};

// One antenna on the mount of a profile. Refused for a mount with one axis and for an X/Y mount: nothing can be chosen
// there.
[[nodiscard]] Result<PlanMount> planMount(const profile::Profile& profile, const pointing::Antenna& antenna);

[[nodiscard]] tracking::MotionBounds boundsOf(const tracking::MotionLimits& limits);

// A place of which the elevation is just beyond a limit counts as on the limit. A pass begins at the horizon, which is
// also the end of many travels.
[[nodiscard]] AxisPosition onTheRim(const AxisPosition& place, const TravelRange& elevations);

}  // namespace boresight::plan
