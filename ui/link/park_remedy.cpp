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

// In whole degrees, which are easy to remember and to type.
std::optional<AxisPosition> above(const pointing::PermittedRegion& region, AxisPosition place)
{
    const Angle highest = region.ranges().elevation.max;
    while (!region.permits(place)) {
        place.elevation = Angle::fromDegrees(std::floor(place.elevation.degrees() + 1.0 + 1e-9));
        if (place.elevation > highest) {
            return std::nullopt;
        }
    }
    return place;
}

}  // namespace

std::optional<ParkRemedy> parkRemedy(const profile::Profile& edited)
{
    const pointing::PermittedRegion region(edited.limits, edited.azimuth.geometry.travel,
                                           edited.elevation.geometry.travel, pointing::PointingModel(edited.pointing));
    const auto& [azimuths, elevations] = region.ranges();
    if (azimuths.min > azimuths.max || elevations.min > elevations.max || region.permits(edited.park)) {
        return std::nullopt;
    }
    const AxisPosition inside{azimuths.clamped(edited.park.azimuth), elevations.clamped(edited.park.elevation)};
    std::optional<AxisPosition> place = above(region, inside);
    if (!place) {
        place = pointing::nearestPermitted(region, inside);
    }
    if (!place) {
        return std::nullopt;
    }
    const QString elevation = shortAngle(place->elevation);
    return ParkRemedy{*place, place->azimuth == edited.park.azimuth
                                  ? ParkWords::tr("Move park to %1").arg(elevation)
                                  : ParkWords::tr("Move park to %1 / %2").arg(shortAngle(place->azimuth), elevation)};
}

}  // namespace boresight::ui
