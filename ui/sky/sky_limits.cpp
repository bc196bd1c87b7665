// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_limits.h"

#include "ui/kit/format.h"

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

// Steps of about one degree look like an arc.
int stepsOf(Angle width)
{
    return std::max(1, static_cast<int>(std::ceil(width.degrees())));
}

// The path clockwise from `from` to `to`, with the elevation changing linearly.
void addArc(QPolygonF& line, const AxisPosition& from, const AxisPosition& to, const pointing::PointingModel& pointing,
            const SkyProjection& sky)
{
    const Angle height = pointing.isSkewed() ? abs(to.elevation - from.elevation) : 0_deg;
    const int steps = stepsOf(std::max(abs(to.azimuth - from.azimuth), height));
    for (int step = 0; step <= steps; ++step) {
        const double part = double(step) / steps;
        line << sky.toPixel(pointing.toSky({from.azimuth + (to.azimuth - from.azimuth) * part,
                                            from.elevation + (to.elevation - from.elevation) * part}));
    }
}

// The part of the sky above the horizon is X and Y from -90° to 90°.
constexpr TravelRange kUpper{.min = -90_deg, .max = 90_deg};

std::vector<SkySector> beyondXY(const Travel& permitted)
{
    const auto& [x, y, pointing] = permitted;
    std::vector<SkySector> sectors;
    const auto add = [&](const TravelRange& ofX, const TravelRange& ofY, const char* text, Angle limit) {
        if (ofX.min < ofX.max && ofY.min < ofY.max) {
            sectors.push_back({ofX.min, ofX.max, ofY.min, ofY.max, named(text, limit), SectorKind::Sector, pointing});
        }
    };
    add({kUpper.min, x.min}, kUpper, QT_TRANSLATE_NOOP("SkyLimits", "X %1"), x.min);
    add({x.max, kUpper.max}, kUpper, QT_TRANSLATE_NOOP("SkyLimits", "X %1"), x.max);
    add(kUpper, {kUpper.min, y.min}, QT_TRANSLATE_NOOP("SkyLimits", "Y %1"), y.min);
    add(kUpper, {y.max, kUpper.max}, QT_TRANSLATE_NOOP("SkyLimits", "Y %1"), y.max);
    return sectors;
}

}  // namespace

Travel travelOf(const profile::Profile& profile)
{
    return {.azimuth = profile.azimuth.geometry.travel,
            .elevation = profile.elevation.geometry.travel,
            .pointing = pointing::PointingModel(profile.pointing)};
}

Travel permitted(const pointing::Region& region, const Travel& travel)
{
    return {.azimuth = overlap(region.azimuth, travel.azimuth),
            .elevation = overlap(region.elevation, travel.elevation),
            .pointing = travel.pointing};
}

std::vector<SkySector> unreachable(const Travel& permitted)
{
    const auto& [azimuth, elevation, pointing] = permitted;
    std::vector<SkySector> sectors;
    if (azimuth.max <= azimuth.min || elevation.max <= elevation.min) {
        return sectors;  // no profile received yet
    }
    if (pointing.isXY()) {
        return beyondXY(permitted);
    }
    // The axis elevations of the horizon and of the zenith.
    const Angle level = permitted.level();
    const Angle zenith = 90_deg + level;
    const auto add = [&](Angle from, Angle to, Angle low, Angle high, const QString& name, SectorKind kind) {
        sectors.push_back({from, to, low, high, name, kind, pointing});
    };
    if (elevation.min > level) {
        add(0_deg, 360_deg, level, elevation.min, named(QT_TRANSLATE_NOOP("SkyLimits", "below %1"), elevation.min),
            SectorKind::Band);
    }
    if (elevation.max < zenith) {
        add(0_deg, 360_deg, elevation.max, zenith, named(QT_TRANSLATE_NOOP("SkyLimits", "above %1"), elevation.max),
            SectorKind::Sector);
    }
    const Angle top = std::clamp(2.0 * zenith - elevation.max, level, std::min(elevation.max, zenith));
    if (azimuth.max - azimuth.min < 360_deg && top > level) {
        add(azimuth.max, azimuth.min + 360_deg, std::max(elevation.min, level), top,
            QCoreApplication::translate("SkyLimits", "out of limits"), SectorKind::Sector);
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
    addArc(rim, {sector.fromAzimuth, sector.fromElevation}, {sector.toAzimuth, sector.fromElevation}, sector.pointing,
           sky);
    QPolygonF inner;
    addArc(inner, {sector.toAzimuth, sector.toElevation}, {sector.fromAzimuth, sector.toElevation}, sector.pointing,
           sky);
    QPainterPath path;
    if (sector.toAzimuth - sector.fromAzimuth >= 360_deg) {
        path.addPolygon(rim);
        path.addPolygon(inner);  // a ring: odd-even fill leaves the middle open
    } else {
        if (sector.pointing.isXY()) {  // the sides are curves, too
            addArc(rim, {sector.toAzimuth, sector.fromElevation}, {sector.toAzimuth, sector.toElevation},
                   sector.pointing, sky);
            addArc(inner, {sector.fromAzimuth, sector.toElevation}, {sector.fromAzimuth, sector.fromElevation},
                   sector.pointing, sky);
        }
        path.addPolygon(rim + inner);
        path.closeSubpath();
    }
    return path;
}

QPainterPath ring(Angle elevation, const pointing::PointingModel& pointing, const SkyProjection& sky)
{
    QPolygonF line;
    QPainterPath path;
    if (pointing.isXY()) {
        addArc(line, {kUpper.min, elevation}, {kUpper.max, elevation}, pointing, sky);
        path.addPolygon(line);
        return path;
    }
    addArc(line, {0_deg, elevation}, {360_deg, elevation}, pointing, sky);
    path.addPolygon(line);
    path.closeSubpath();
    return path;
}

QPainterPath meridian(Angle azimuth, Angle from, Angle to, const pointing::PointingModel& pointing,
                      const SkyProjection& sky)
{
    QPolygonF line;
    if (pointing.isXY()) {
        addArc(line, {azimuth, kUpper.min}, {azimuth, kUpper.max}, pointing, sky);
    } else {
        addArc(line, {azimuth, from}, {azimuth, to}, pointing, sky);
    }
    QPainterPath path;
    path.addPolygon(line);
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
        addArc(line, {horizon[i].azimuth, horizon[i].elevation}, {wrapped, next.elevation}, {}, sky);
    }
    path.addPolygon(line);
    path.closeSubpath();
    return path;
}

}  // namespace boresight::ui
