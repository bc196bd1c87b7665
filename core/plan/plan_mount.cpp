// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/plan_mount.h"

#include "core/base/text.h"

namespace boresight::plan {

Result<PlanMount> planMount(const profile::Profile& profile, const pointing::Antenna& antenna)
{
    if (profile.missing()) {
        return failure(ErrorCode::NotAvailable,
                       Text::tr("A pass is planned for a mount with two axes. This mount has one axis."));
    }
    const pointing::PointingModel pointing(profile.termsOf(antenna));
    if (pointing.isXY()) {
        return failure(
            ErrorCode::NotAvailable,
            Text::tr("An X/Y mount needs no plan: it has no cable to unwrap, and no keyhole at the zenith."));
    }
    return PlanMount{.region = pointing::PermittedRegion(profile.limits, profile.azimuth.geometry.travel,
                                                         profile.elevation.geometry.travel, pointing),
                     .pointing = pointing,
                     .azimuth = profile.azimuth.limits,
                     .elevation = profile.elevation.limits,
                     .beamWidth = antenna.beamWidth};
}

tracking::MotionBounds boundsOf(const tracking::MotionLimits& limits)
{
    return {.speed = limits.speed.radians(), .acceleration = limits.acceleration.radians()};
}

AxisPosition onTheRim(const AxisPosition& place, const TravelRange& elevations)
{
    constexpr Angle kRim = Angle::fromDegrees(0.01);
    const Angle inside = elevations.clamped(place.elevation);
    return abs(inside - place.elevation) <= kRim ? AxisPosition{place.azimuth, inside} : place;
}

}  // namespace boresight::plan
