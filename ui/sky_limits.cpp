// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky_limits.h"

#include "ui/format.h"

#include <QCoreApplication>

#include <algorithm>

namespace boresight::ui {

namespace {

QString named(const char* text, Angle angle)
{
    return QCoreApplication::translate("SkyLimits", text).arg(angleText(angle, 0));
}

}  // namespace

std::vector<SkySector> unreachable(const TravelRange& azimuth, const TravelRange& elevation)
{
    std::vector<SkySector> sectors;
    if (azimuth.max <= azimuth.min || elevation.max <= elevation.min) {
        return sectors;  // no profile heard of yet
    }
    if (elevation.min > 0_deg) {
        sectors.push_back(
            {0_deg, 360_deg, 0_deg, elevation.min, named(QT_TRANSLATE_NOOP("SkyLimits", "below %1"), elevation.min)});
    }
    if (elevation.max < 90_deg) {
        sectors.push_back(
            {0_deg, 360_deg, elevation.max, 90_deg, named(QT_TRANSLATE_NOOP("SkyLimits", "above %1"), elevation.max)});
    }
    const Angle top = std::clamp(180_deg - elevation.max, 0_deg, std::min(elevation.max, 90_deg));
    if (azimuth.max - azimuth.min < 360_deg && top > 0_deg) {
        sectors.push_back({azimuth.max, azimuth.min + 360_deg, std::max(elevation.min, 0_deg), top,
                           QCoreApplication::translate("SkyLimits", "out of travel")});
    }
    return sectors;
}

}  // namespace boresight::ui
