// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/park_remedy.h"

#include "core/base/numbers.h"
#include "core/pointing/nearest_permitted.h"
#include "core/pointing/permitted_region.h"

#include <QCoreApplication>

#include <cmath>

namespace boresight::ui {

namespace {

class ParkWords
{
    Q_DECLARE_TR_FUNCTIONS(ParkWords)
};

QString shortAngle(Angle angle)
{
    const bool whole = std::abs(angle.degrees() - std::round(angle.degrees())) < 0.05;
    return QString::fromStdString(formatFixed(angle.degrees(), whole ? 0 : 1)) + QStringLiteral("°");
}

}  // namespace

std::optional<ParkRemedy> parkRemedy(const profile::Profile& edited)
{
    const pointing::PermittedRegion region(edited.limits, edited.azimuth.geometry.travel,
                                           edited.elevation.geometry.travel, pointing::PointingModel(edited.pointing));
    if (region.permits(edited.park)) {
        return std::nullopt;
    }
    const std::optional<AxisPosition> place = pointing::easyPermitted(region, edited.park);
    if (!place) {
        return std::nullopt;
    }
    const QString elevation = shortAngle(place->elevation);
    return ParkRemedy{*place, place->azimuth == edited.park.azimuth
                                  ? ParkWords::tr("Move park to %1").arg(elevation)
                                  : ParkWords::tr("Move park to %1 / %2").arg(shortAngle(place->azimuth), elevation)};
}

}  // namespace boresight::ui
