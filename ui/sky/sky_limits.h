// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/pointing_model.h"
#include "core/pointing/region.h"
#include "core/profile/profile.h"
#include "core/units/sky.h"
#include "ui/sky/sky_projection.h"

#include <QPainterPath>
#include <QString>

#include <vector>

// The parts of the sky that travel, limits and keep-outs exclude, and their shapes on the plot. Keep-outs and horizon
// are true directions. Travel and limits are axis angles, and are drawn where the beam then points. For drawing only:
// the station decides what is permitted, from the same values.
namespace boresight::ui {

enum class SectorKind
{
    Band,    // below the lowest elevation: a tint
    Sector,  // out of reach or outside the limits: hatched
    KeepOut  // named by the operator: hatched in the other direction
};

// A part of the sky between two azimuths (clockwise from the first) and two elevations. They are axis angles if the
// sector has a pointing model.
struct SkySector
{
    Angle fromAzimuth;
    Angle toAzimuth;  // unwrapped: larger than fromAzimuth
    Angle fromElevation;
    Angle toElevation;
    QString name;
    SectorKind kind = SectorKind::Sector;
    pointing::PointingModel pointing{};

    [[nodiscard]] SkyPointing beam(Angle azimuth, Angle elevation) const
    {
        return pointing.toSky({azimuth, elevation});
    }
    bool operator==(const SkySector&) const = default;
};

// The travel of the axes, and where the beam points then.
struct Travel
{
    TravelRange azimuth;
    TravelRange elevation;
    pointing::PointingModel pointing{};

    // The axis elevation at which the beam points to the horizon.
    [[nodiscard]] Angle level() const { return -pointing.terms().elevationOffset; }
    bool operator==(const Travel&) const = default;
};

[[nodiscard]] Travel travelOf(const profile::Profile& profile);

// The range in which the mount may work: the limits within the travel.
[[nodiscard]] Travel permitted(const pointing::Region& region, const Travel& travel);

// The areas that the axes may not reach. Those of an X/Y mount lie beyond the ends of X and Y. An elevation range over
// the top reaches a closed azimuth sector from the other side, above an elevation of 180° - max.
[[nodiscard]] std::vector<SkySector> unreachable(const Travel& permitted);

[[nodiscard]] SkySector sectorOf(const pointing::KeepOut& keepOut);

// All of them, from the bottom layer up.
[[nodiscard]] std::vector<SkySector> sectorsOf(const pointing::Region& region, const Travel& travel);

[[nodiscard]] QPainterPath outline(const SkySector& sector, const SkyProjection& sky);
// In axis angles: a circle around their zenith, and the line upwards at one azimuth. For X and Y: the line at one Y,
// and the line at one X, both from horizon to horizon.
[[nodiscard]] QPainterPath ring(Angle elevation, const pointing::PointingModel& pointing, const SkyProjection& sky);
[[nodiscard]] QPainterPath meridian(Angle azimuth, Angle from, Angle to, const pointing::PointingModel& pointing,
                                    const SkyProjection& sky);
// The horizon as a closed line, empty without points. The sky below it lies between the line and the rim.
[[nodiscard]] QPainterPath horizonLine(const std::vector<pointing::HorizonPoint>& horizon, const SkyProjection& sky);

}  // namespace boresight::ui
