// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/region_edit.h"

#include "ui/kit/format.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace boresight::ui {

namespace {

using pointing::HorizonPoint;
using pointing::KeepOut;
using pointing::Region;

constexpr Angle kNarrowest = 0.5_deg;  // of a range or keep-out made smaller by dragging
constexpr Angle kKeepOutSize = 20_deg;

class RegionEdit
{
    Q_DECLARE_TR_FUNCTIONS(RegionEdit)
};

QString fromToText(Angle from, Angle to)
{
    return angleText(from, 1) + QStringLiteral("…") + angleText(to, 1);
}

bool takenAzimuth(const std::vector<HorizonPoint>& horizon, Angle azimuth)
{
    return std::ranges::any_of(horizon, [&](const HorizonPoint& p) { return abs(p.azimuth - azimuth) < 0.01_deg; });
}

std::size_t insertSorted(std::vector<HorizonPoint>& horizon, const HorizonPoint& point)
{
    const auto place = std::ranges::lower_bound(horizon, point.azimuth, {}, &HorizonPoint::azimuth);
    const auto index = place - horizon.begin();
    horizon.insert(place, point);
    return static_cast<std::size_t>(index);
}

// Rounded as a person would type it, because sums of angles have rounding errors between degrees and radians.
Angle tidied(Angle angle)
{
    return Angle::fromDegrees(std::round(angle.degrees() * 1e6) / 1e6);
}

Angle inCircle(Angle azimuth)
{
    return tidied(tidied(azimuth).wrapped360());
}

std::string freeName(const std::vector<KeepOut>& keepOuts)
{
    for (int number = 1;; ++number) {
        const std::string name = RegionEdit::tr("keep-out %1").arg(number).toStdString();
        if (std::ranges::find(keepOuts, name, &KeepOut::name) == keepOuts.end()) {
            return name;
        }
    }
}

// In whole degrees, at most 0°: directions that the beam can reach without a horizon must stay in reach.
Angle lowestOfTheSky(const Region& region, const Travel& travel)
{
    const Travel limits = permitted(region, travel);
    const Angle axis = std::max(limits.elevation.min, -90_deg);
    Angle lowest = 0_deg;
    if (travel.pointing.isXY()) {
        return std::clamp(90_deg - std::max(-limits.azimuth.min, limits.azimuth.max), -90_deg, 0_deg);
    }
    for (Angle azimuth; azimuth < 360_deg; azimuth += 30_deg) {
        lowest = std::min(lowest, travel.pointing.toSky({azimuth, axis}).elevation);
    }
    return std::max(Angle::fromDegrees(std::floor(lowest.degrees() + 1e-6)), -90_deg);
}

// The additional points that keep a level horizon unchanged on both sides of a new point.
std::vector<HorizonPoint> feetOf(const HorizonPoint& point, const Region& region, const Travel& travel)
{
    const std::vector<HorizonPoint>& horizon = region.horizon;
    Angle level = lowestOfTheSky(region, travel);
    Angle before = 360_deg;
    Angle behind = 360_deg;
    if (!horizon.empty()) {
        const auto next = std::ranges::lower_bound(horizon, point.azimuth, {}, &HorizonPoint::azimuth);
        const HorizonPoint& right = next == horizon.end() ? horizon.front() : *next;
        const HorizonPoint& left = next == horizon.begin() ? horizon.back() : *std::prev(next);
        if (left.elevation != right.elevation) {
            return {};
        }
        level = left.elevation;
        before = (point.azimuth - left.azimuth).wrapped360();
        behind = (right.azimuth - point.azimuth).wrapped360();
    }
    std::vector<HorizonPoint> feet;
    if (point.elevation != level && before > kHillFlank) {
        feet.push_back({inCircle(point.azimuth - kHillFlank), level});
    }
    if (point.elevation != level && behind > kHillFlank) {
        feet.push_back({inCircle(point.azimuth + kHillFlank), level});
    }
    return feet;
}

// If the axes do not show true directions, the text marks the angle as an axis angle.
QString axisText(Angle angle, const Travel& travel)
{
    const QString text = angleText(angle, 1);
    return travel.pointing.isIdentity() ? text : RegionEdit::tr("%1\nof the axis").arg(text);
}

}  // namespace

Angle snapped(Angle angle, Angle step)
{
    // Division instead of multiplication: 3 × 0.1 is not 0.3, and the table would show the difference.
    const double perDegree = std::round(1.0 / step.degrees());
    return Angle::fromDegrees(std::round(angle.degrees() * perDegree) / perDegree);
}

QString describe(const Region& region, const Travel& travel, const Grip& grip)
{
    const Travel limits = permitted(region, travel);
    switch (grip.part) {
        case RegionPart::AzimuthMin:
            return RegionEdit::tr("azimuth axis limit\nfrom %1").arg(axisText(limits.azimuth.min, limits));
        case RegionPart::AzimuthMax:
            return RegionEdit::tr("azimuth axis limit\nto %1").arg(axisText(limits.azimuth.max, limits));
        case RegionPart::ElevationMin:
            return RegionEdit::tr("lowest elevation\n%1").arg(axisText(limits.elevation.min, limits));
        case RegionPart::ElevationMax:
            return RegionEdit::tr("highest elevation\n%1").arg(axisText(limits.elevation.max, limits));
        case RegionPart::HorizonPoint: {
            const HorizonPoint& point = region.horizon.at(grip.index);
            return RegionEdit::tr("horizon\naz %1\nel %2")
                .arg(azimuthText(point.azimuth, 1), angleText(point.elevation, 1));
        }
        case RegionPart::KeepOut: {
            const KeepOut& keepOut = region.keepOuts.at(grip.index);
            return RegionEdit::tr("%1\naz %2\nel %3")
                .arg(QString::fromStdString(keepOut.name), fromToText(keepOut.azimuthFrom, keepOut.azimuthTo),
                     fromToText(keepOut.elevationMin, keepOut.elevationMax));
        }
    }
    return {};
}

RegionDrag::RegionDrag(Region start, const Travel& travel, const Grip& grip, const SkyPointing& at)
    : m_start(std::move(start)),
      m_travel(travel),
      m_grip(grip),
      m_startIndex(grip.index),
      m_at(inHand(at)),
      m_azimuth(m_at.azimuth)
{}

// A limit is an axis angle, so the pointer is converted to axis angles.
SkyPointing RegionDrag::inHand(const SkyPointing& place) const
{
    if (m_grip.part == RegionPart::HorizonPoint || m_grip.part == RegionPart::KeepOut) {
        return place;
    }
    const AxisPosition axes = m_travel.pointing.toAxes(place).axes;
    return {axes.azimuth, axes.elevation};
}

Region RegionDrag::to(const SkyPointing& now, Angle snap)
{
    const SkyPointing held = inHand(now);
    m_azimuth = held.azimuth.nearestTo(m_azimuth);
    const SkyPointing hand{m_azimuth, held.elevation};
    Region region = m_start;
    const Travel limits = permitted(m_start, m_travel);
    const TravelRange& azimuth = limits.azimuth;
    const TravelRange& elevation = limits.elevation;
    const auto within = [snap](Angle angle, Angle min, Angle max) {
        return std::max(min, std::min(snapped(angle, snap), max));
    };
    // The pointer gives a direction. The wrap is that of the limit being dragged.
    const Angle turned = m_azimuth - m_at.azimuth;
    switch (m_grip.part) {
        case RegionPart::AzimuthMin:
            region.azimuth.min =
                within(m_at.azimuth.nearestTo(azimuth.min) + turned, m_travel.azimuth.min, azimuth.max - kNarrowest);
            break;
        case RegionPart::AzimuthMax:
            region.azimuth.max =
                within(m_at.azimuth.nearestTo(azimuth.max) + turned, azimuth.min + kNarrowest, m_travel.azimuth.max);
            break;
        case RegionPart::ElevationMin:
            region.elevation.min = within(hand.elevation, m_travel.elevation.min, elevation.max - kNarrowest);
            break;
        case RegionPart::ElevationMax:
            region.elevation.max = within(hand.elevation, elevation.min + kNarrowest, m_travel.elevation.max);
            break;
        case RegionPart::HorizonPoint:
            dragHorizonPoint(region, hand, snap);
            break;
        case RegionPart::KeepOut:
            dragKeepOut(region.keepOuts.at(m_startIndex), hand, snap);
            break;
    }
    return region;
}

void RegionDrag::dragHorizonPoint(Region& region, const SkyPointing& now, Angle snap)
{
    HorizonPoint point = region.horizon.at(m_startIndex);
    region.horizon.erase(region.horizon.begin() + static_cast<std::ptrdiff_t>(m_startIndex));
    point.elevation = snapped(now.elevation, snap);
    const Angle azimuth = inCircle(snapped(now.azimuth, snap));
    if (!takenAzimuth(region.horizon, azimuth)) {
        point.azimuth = azimuth;
    }
    m_grip.index = insertSorted(region.horizon, point);
}

void RegionDrag::dragKeepOut(KeepOut& keepOut, const SkyPointing& now, Angle snap) const
{
    const KeepOutSides& sides = m_grip.sides;
    const Angle start = keepOut.azimuthFrom;
    const Angle width = (keepOut.azimuthTo - start).wrapped360();
    const Angle turned = now.azimuth - m_at.azimuth;
    const Angle raised = now.elevation - m_at.elevation;
    if (sides.from && sides.to) {
        const Angle from = snapped(start + turned, snap);
        keepOut.azimuthFrom = inCircle(from);
        keepOut.azimuthTo = inCircle(from + width);
    } else if (sides.from) {
        keepOut.azimuthFrom = inCircle(std::clamp(snapped(start + turned, snap), start + width - 360_deg + kNarrowest,
                                                  start + width - kNarrowest));
    } else if (sides.to) {
        keepOut.azimuthTo = inCircle(
            std::clamp(snapped(start + width + turned, snap), start + kNarrowest, start + 360_deg - kNarrowest));
    }
    const Angle height = tidied(keepOut.elevationMax - keepOut.elevationMin);
    if (sides.min && sides.max) {
        keepOut.elevationMin = std::clamp(snapped(keepOut.elevationMin + raised, snap), 0_deg, tidied(90_deg - height));
        keepOut.elevationMax = tidied(keepOut.elevationMin + height);
    } else if (sides.min) {
        keepOut.elevationMin =
            std::min(snapped(keepOut.elevationMin + raised, snap), tidied(keepOut.elevationMax - kNarrowest));
    } else if (sides.max) {
        keepOut.elevationMax =
            std::clamp(snapped(keepOut.elevationMax + raised, snap), tidied(keepOut.elevationMin + kNarrowest),
                       std::max(keepOut.elevationMax, 90_deg));
    }
}

std::size_t addHorizonPoint(Region& region, const Travel& travel, const SkyPointing& at)
{
    Angle azimuth = inCircle(snapped(at.azimuth, kNarrowest));
    while (takenAzimuth(region.horizon, azimuth)) {
        azimuth = inCircle(azimuth + kNarrowest);
    }
    const HorizonPoint point{azimuth, snapped(at.elevation, kNarrowest)};
    for (const HorizonPoint& foot : feetOf(point, region, travel)) {
        insertSorted(region.horizon, foot);
    }
    return insertSorted(region.horizon, point);
}

std::size_t addKeepOut(Region& region, const SkyPointing& centre)
{
    const Angle low =
        std::clamp(snapped(centre.elevation - kKeepOutSize * 0.5, kNarrowest), 0_deg, 90_deg - kKeepOutSize);
    const Angle from = snapped(centre.azimuth - kKeepOutSize * 0.5, kNarrowest);
    region.keepOuts.push_back({.name = freeName(region.keepOuts),
                               .azimuthFrom = inCircle(from),
                               .azimuthTo = inCircle(from + kKeepOutSize),
                               .elevationMin = low,
                               .elevationMax = tidied(low + kKeepOutSize)});
    return region.keepOuts.size() - 1;
}

void remove(Region& region, const Grip& grip)
{
    const auto drop = [&grip](auto& list) {
        if (grip.index < list.size()) {
            list.erase(list.begin() + static_cast<std::ptrdiff_t>(grip.index));
        }
    };
    if (grip.part == RegionPart::HorizonPoint) {
        drop(region.horizon);
    } else if (grip.part == RegionPart::KeepOut) {
        drop(region.keepOuts);
    }
}

}  // namespace boresight::ui
