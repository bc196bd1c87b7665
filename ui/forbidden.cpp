// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forbidden.h"

#include "core/pointing/mount_model.h"
#include "core/pointing/permitted_region.h"

#include <QCoreApplication>

namespace boresight::ui {

QString whyForbidden(const StationStatus& status, const SkyPointing& direction)
{
    const profile::Profile& profile = *status.profile;
    const pointing::PermittedRegion region(profile.limits, profile.azimuth.geometry.travel,
                                           profile.elevation.geometry.travel);
    pointing::MountModel model(profile.azimuth.geometry, profile.elevation.geometry);
    model.limitTo(region.ranges().azimuth, region.ranges().elevation);
    const AxisPosition now{status.azimuth.actual.value_or(0_deg), status.elevation.actual.value_or(0_deg)};
    const pointing::Resolved resolved = model.resolve(direction, now);
    const std::string reason = resolved.limited ? resolved.reason : region.obstacle(resolved.position);
    return reason.empty()
               ? QString()
               : QCoreApplication::translate("Forbidden", "forbidden: %1").arg(QString::fromStdString(reason));
}

}  // namespace boresight::ui
