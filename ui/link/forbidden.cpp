// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/forbidden.h"

#include "core/pointing/missing_axis.h"
#include "core/pointing/mount_model.h"
#include "core/pointing/nearest_permitted.h"
#include "core/pointing/permitted_region.h"
#include "core/pointing/sun_keep_out.h"

#include <QCoreApplication>

#include <array>

namespace boresight::ui {

namespace {

pointing::MountModel modelOf(const StationStatus& status)
{
    const profile::Profile& profile = *status.profile;
    pointing::MountModel model(profile.azimuth.geometry, profile.elevation.geometry,
                               pointing::PointingModel(profile.pointing));
    for (const Axis axis : kAxes) {
        if (!status.capabilities.has(axis)) {
            model.leaveOut(axis);
        }
    }
    return model;
}

// As the station obeys it: what a missing axis would show is not known.
pointing::PermittedRegion regionOf(const StationStatus& status, const pointing::PointingModel& pointing)
{
    const profile::Profile& profile = *status.profile;
    pointing::Region region = pointing::withSun(profile.limits, status.sunKeepOuts);
    std::array<TravelRange, 2> travel;
    for (const Axis axis : kAxes) {
        const bool present = status.capabilities.has(axis);
        travel[index(axis)] = present ? profile.axis(axis).geometry.travel : pointing::kMissingAxisTravel;
        region = present ? region : pointing::withoutAxis(region, axis);
    }
    return {region, travel[0], travel[1], pointing};
}

// What the mount of this status reaches, from where it is.
struct Reach
{
    explicit Reach(const StationStatus& status)
        : model(modelOf(status)),
          region(regionOf(status, model.pointing())),
          now{status.azimuth.actual.value_or(0_deg), status.elevation.actual.value_or(0_deg)}
    {
        model.limitTo(region.ranges().azimuth, region.ranges().elevation);
    }
    [[nodiscard]] pointing::Resolved resolve(const SkyPointing& direction) const
    {
        return model.resolve(direction, now);
    }

    pointing::MountModel model;
    pointing::PermittedRegion region;
    AxisPosition now;
};

QString forbidden(const QString& reason)
{
    return reason.isEmpty() ? QString() : QCoreApplication::translate("Forbidden", "forbidden: %1").arg(reason);
}

}  // namespace

QString whyForbidden(const StationStatus& status, const SkyPointing& direction)
{
    const Reach reach(status);
    const pointing::Resolved resolved = reach.resolve(direction);
    return forbidden(resolved.limited ? resolved.reason : reach.region.obstacle(resolved.position));
}

std::optional<SkyPointing> nearestAllowed(const StationStatus& status, const SkyPointing& direction)
{
    const Reach reach(status);
    const pointing::Resolved resolved = reach.resolve(direction);
    const auto place = pointing::nearestPermitted(reach.region, resolved.position);
    if (!place || (!resolved.limited && *place == resolved.position)) {
        return std::nullopt;
    }
    const SkyPointing beam = pointing::upright(reach.region.beamAt(*place));
    return SkyPointing{beam.azimuth.wrapped360(), beam.elevation};
}

}  // namespace boresight::ui
