// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/region_grip.h"

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

double distance(QPointF a, QPointF b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

class Finder
{
public:
    Finder(const pointing::Region& region, const Travel& travel, const SkyProjection& sky, QPointF pixel, double reach)
        : m_region(region), m_limits(permitted(region, travel)), m_sky(sky), m_pixel(pixel), m_reach(reach)
    {}

    [[nodiscard]] std::optional<Grip> find() const
    {
        if (auto grip = horizonPoint()) {
            return grip;
        }
        if (auto grip = azimuthLimit()) {
            return grip;
        }
        if (auto grip = keepOutSide()) {
            return grip;
        }
        if (auto grip = elevationLimit()) {
            return grip;
        }
        return wholeKeepOut();
    }

private:
    [[nodiscard]] bool hits(const SkyPointing& place) const
    {
        return distance(m_sky.toPixel(place), m_pixel) <= m_reach;
    }

    [[nodiscard]] SkyPointing under() const { return m_sky.toSky(m_pixel); }

    // The axis angles at which the beam points to this place.
    [[nodiscard]] AxisPosition axesUnder() const { return m_limits.pointing.toAxes(under()).axes; }
    [[nodiscard]] bool onLimitRing(Angle elevation) const
    {
        return abs(axesUnder().elevation - std::max(elevation, m_limits.level())) / 90_deg * m_sky.radius <= m_reach;
    }
    [[nodiscard]] bool onLimitRay(Angle azimuth) const
    {
        return onRay(under().azimuth + (azimuth - axesUnder().azimuth));
    }

    // Distance in pixels from the ring of an elevation, and from the ray of an azimuth on its side of the zenith.
    [[nodiscard]] bool onRing(Angle elevation) const
    {
        const double ring = distance(m_sky.toPixel({0_deg, elevation}), m_sky.zenith);
        return std::abs(distance(m_pixel, m_sky.zenith) - ring) <= m_reach;
    }
    [[nodiscard]] bool onRay(Angle azimuth) const
    {
        const Angle aside = (under().azimuth - azimuth).wrapped180();
        return abs(aside) < 90_deg && std::abs(std::sin(aside.radians())) * distance(m_pixel, m_sky.zenith) <= m_reach;
    }

    [[nodiscard]] std::optional<Grip> horizonPoint() const
    {
        for (std::size_t i = 0; i < m_region.horizon.size(); ++i) {
            if (hits({m_region.horizon[i].azimuth, m_region.horizon[i].elevation})) {
                return Grip{.part = RegionPart::HorizonPoint, .index = i};
            }
        }
        return std::nullopt;
    }

    // The limits of X and Y are typed in the panel. If both limits have the same direction (0…360°), the permitted side
    // decides which one is meant.
    [[nodiscard]] std::optional<Grip> azimuthLimit() const
    {
        const auto& [min, max] = m_limits.azimuth;
        const bool wholeCircle = max - min >= 360_deg;
        if (m_limits.pointing.isXY() || max <= min ||
            (wholeCircle && axesUnder().elevation > m_limits.level() + kLimitMark)) {
            return std::nullopt;
        }
        const bool onMin = onLimitRay(min);
        const bool onMax = onLimitRay(max);
        if (!onMin && !onMax) {
            return std::nullopt;
        }
        const bool clockwiseOfMin = (axesUnder().azimuth - min).wrapped180() >= 0_deg;
        return Grip{.part = onMin && (!onMax || clockwiseOfMin) ? RegionPart::AzimuthMin : RegionPart::AzimuthMax};
    }

    [[nodiscard]] std::optional<Grip> elevationLimit() const
    {
        const auto& [min, max] = m_limits.elevation;
        if (m_limits.pointing.isXY() || max <= min) {
            return std::nullopt;
        }
        if (max <= m_limits.level() + 90_deg && onLimitRing(max)) {
            return Grip{.part = RegionPart::ElevationMax};
        }
        return onLimitRing(min) ? std::optional(Grip{.part = RegionPart::ElevationMin}) : std::nullopt;
    }

    [[nodiscard]] KeepOutSides sidesHit(const pointing::KeepOut& keepOut) const
    {
        const SkySector sector = sectorOf(keepOut);
        const Angle azimuth = sector.fromAzimuth + (under().azimuth - sector.fromAzimuth).wrapped360();
        const bool beside = azimuth <= sector.toAzimuth;
        const bool between = under().elevation >= sector.fromElevation && under().elevation <= sector.toElevation;
        const bool from = onRay(sector.fromAzimuth);
        const bool to = onRay(sector.toAzimuth);
        const bool min = onRing(sector.fromElevation);
        const bool max = onRing(sector.toElevation);
        const bool nearAzimuth = beside || from || to;
        const bool nearElevation = between || min || max;
        if (!nearAzimuth || !nearElevation) {
            return {};
        }
        return {.from = from, .to = to && !from, .min = min && !max, .max = max};
    }

    [[nodiscard]] std::optional<Grip> keepOutSide() const
    {
        std::optional<Grip> edge;
        for (std::size_t i = m_region.keepOuts.size(); i-- > 0;) {
            const KeepOutSides sides = sidesHit(m_region.keepOuts[i]);
            const Grip grip{.part = RegionPart::KeepOut, .index = i, .sides = sides};
            if ((sides.from || sides.to) && (sides.min || sides.max)) {
                return grip;
            }
            if (!edge && sides != KeepOutSides{}) {
                edge = grip;
            }
        }
        return edge;
    }

    [[nodiscard]] std::optional<Grip> wholeKeepOut() const
    {
        for (std::size_t i = m_region.keepOuts.size(); i-- > 0;) {
            if (outline(sectorOf(m_region.keepOuts[i]), m_sky).contains(m_pixel)) {
                return Grip{.part = RegionPart::KeepOut, .index = i, .sides = {true, true, true, true}};
            }
        }
        return std::nullopt;
    }

    const pointing::Region& m_region;
    Travel m_limits;
    SkyProjection m_sky;
    QPointF m_pixel;
    double m_reach;
};

}  // namespace

std::optional<Grip> gripAt(const pointing::Region& region, const Travel& travel, const SkyProjection& sky,
                           QPointF pixel, double reach)
{
    return Finder(region, travel, sky, pixel, reach).find();
}

}  // namespace boresight::ui
