// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky_limits.h"

#include "ui/format.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

QString named(const char* text, Angle angle)
{
    return QCoreApplication::translate("SkyLimits", text).arg(angleText(angle, 0));
}

TravelRange overlap(const TravelRange& a, const TravelRange& b)
{
    return {.min = std::max(a.min, b.min), .max = std::min(a.max, b.max)};
}

// Steps of about a degree, which no eye tells from an arc.
int stepsOf(Angle width)
{
    return std::max(1, static_cast<int>(std::ceil(width.degrees())));
}

// The way clockwise from `from` to `to` at one elevation after the other, straight in between.
void addArc(QPolygonF& line, const SkyPointing& from, const SkyPointing& to, const SkyProjection& sky)
{
    const int steps = stepsOf(abs(to.azimuth - from.azimuth));
    for (int step = 0; step <= steps; ++step) {
        const double part = double(step) / steps;
        line << sky.toPixel({from.azimuth + (to.azimuth - from.azimuth) * part,
                             from.elevation + (to.elevation - from.elevation) * part});
    }
}

}  // namespace

Travel permitted(const pointing::Region& region, const Travel& travel)
{
    return {.azimuth = overlap(region.azimuth, travel.azimuth),
            .elevation = overlap(region.elevation, travel.elevation)};
}

std::vector<SkySector> unreachable(const Travel& permitted)
{
    const auto& [azimuth, elevation] = permitted;
    std::vector<SkySector> sectors;
    if (azimuth.max <= azimuth.min || elevation.max <= elevation.min) {
        return sectors;  // no profile heard of yet
    }
    if (elevation.min > 0_deg) {
        sectors.push_back({0_deg, 360_deg, 0_deg, elevation.min,
                           named(QT_TRANSLATE_NOOP("SkyLimits", "below %1"), elevation.min), SectorKind::Band});
    }
    if (elevation.max < 90_deg) {
        sectors.push_back({0_deg, 360_deg, elevation.max, 90_deg,
                           named(QT_TRANSLATE_NOOP("SkyLimits", "above %1"), elevation.max), SectorKind::Sector});
    }
    const Angle top = std::clamp(180_deg - elevation.max, 0_deg, std::min(elevation.max, 90_deg));
    if (azimuth.max - azimuth.min < 360_deg && top > 0_deg) {
        sectors.push_back({azimuth.max, azimuth.min + 360_deg, std::max(elevation.min, 0_deg), top,
                           QCoreApplication::translate("SkyLimits", "out of limits"), SectorKind::Sector});
    }
    return sectors;
}

SkySector sectorOf(const pointing::KeepOut& keepOut)
{
    const Angle width = keepOut.azimuthTo - keepOut.azimuthFrom;
    return {.fromAzimuth = keepOut.azimuthFrom,
            .toAzimuth = keepOut.azimuthFrom + (width < 360_deg ? width.wrapped360() : width),
            .fromElevation = keepOut.elevationMin,
            .toElevation = keepOut.elevationMax,
            .name = QString::fromStdString(keepOut.name),
            .kind = SectorKind::KeepOut};
}

std::vector<SkySector> sectorsOf(const pointing::Region& region, const Travel& travel)
{
    std::vector<SkySector> sectors = unreachable(permitted(region, travel));
    for (const pointing::KeepOut& keepOut : region.keepOuts) {
        sectors.push_back(sectorOf(keepOut));
    }
    return sectors;
}

QPainterPath outline(const SkySector& sector, const SkyProjection& sky)
{
    QPolygonF rim;
    addArc(rim, {sector.fromAzimuth, sector.fromElevation}, {sector.toAzimuth, sector.fromElevation}, sky);
    QPolygonF inner;
    addArc(inner, {sector.toAzimuth, sector.toElevation}, {sector.fromAzimuth, sector.toElevation}, sky);
    QPainterPath path;
    if (sector.toAzimuth - sector.fromAzimuth >= 360_deg) {
        path.addPolygon(rim);
        path.addPolygon(inner);  // a ring: odd-even fill leaves the middle open
    } else {
        path.addPolygon(rim + inner);
        path.closeSubpath();
    }
    return path;
}

QPainterPath ring(Angle elevation, const SkyProjection& sky)
{
    const double radius = sky.zenith.y() - sky.toPixel({0_deg, elevation}).y();
    QPainterPath path;
    path.addEllipse(sky.zenith, radius, radius);
    return path;
}

QPainterPath meridian(Angle azimuth, Angle from, Angle to, const SkyProjection& sky)
{
    QPainterPath path(sky.toPixel({azimuth, from}));
    path.lineTo(sky.toPixel({azimuth, to}));
    return path;
}

QPainterPath horizonLine(const std::vector<pointing::HorizonPoint>& horizon, const SkyProjection& sky)
{
    QPainterPath path;
    if (horizon.empty()) {
        return path;
    }
    QPolygonF line;
    for (std::size_t i = 0; i < horizon.size(); ++i) {
        const pointing::HorizonPoint& next = horizon[(i + 1) % horizon.size()];
        const Angle wrapped = i + 1 < horizon.size() ? next.azimuth : next.azimuth + 360_deg;
        addArc(line, {horizon[i].azimuth, horizon[i].elevation}, {wrapped, next.elevation}, sky);
    }
    path.addPolygon(line);
    path.closeSubpath();
    return path;
}

}  // namespace boresight::ui
