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

// Which parts of the sky travel, limits and keep-outs leave out, and their shapes on the plot. Keep-outs and horizon
// are true directions; travel and limits are mechanical and are drawn where the beam then looks. For drawing only: the
// station decides what is permitted, from the same values.
namespace boresight::ui {

enum class SectorKind
{
    Band,    // below the lowest elevation: a tint
    Sector,  // out of reach or limits: hatched
    KeepOut  // named by the operator: hatched the other way
};

// A piece of sky between two azimuths (clockwise from the first) and two elevations, of the axes if they have a model.
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

// How far the cable and the mechanics let the axes go, and where they look there.
struct Travel
{
    TravelRange azimuth;
    TravelRange elevation;
    pointing::PointingModel pointing{};

    // The elevation of the axes at which they look to the horizon.
    [[nodiscard]] Angle level() const { return -pointing.terms().elevationOffset; }
    bool operator==(const Travel&) const = default;
};

[[nodiscard]] Travel travelOf(const profile::Profile& profile);

// Where the mount may work: the limits, as far as the travel goes.
[[nodiscard]] Travel permitted(const pointing::Region& region, const Travel& travel);

// What the axes may not reach. An axis range over the top reaches a closed azimuth sector from the other side, from the
// elevation 180° - max on.
[[nodiscard]] std::vector<SkySector> unreachable(const Travel& permitted);

[[nodiscard]] SkySector sectorOf(const pointing::KeepOut& keepOut);

// All of it, from below.
[[nodiscard]] std::vector<SkySector> sectorsOf(const pointing::Region& region, const Travel& travel);

[[nodiscard]] QPainterPath outline(const SkySector& sector, const SkyProjection& sky);
// Of the axes: a circle around their zenith, and the way up at one azimuth.
[[nodiscard]] QPainterPath ring(Angle elevation, const pointing::PointingModel& pointing, const SkyProjection& sky);
[[nodiscard]] QPainterPath meridian(Angle azimuth, Angle from, Angle to, const pointing::PointingModel& pointing,
                                    const SkyProjection& sky);
// The horizon as a closed line, empty without points; the sky below it is between the line and the rim.
[[nodiscard]] QPainterPath horizonLine(const std::vector<pointing::HorizonPoint>& horizon, const SkyProjection& sky);

}  // namespace boresight::ui
