// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/permitted_region.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/pointing/mount_model.h"
#include "core/pointing/slits.h"

#include <algorithm>
#include <cmath>

namespace boresight::pointing {

namespace {

const Angle kFullTurn = Angle::fromTurns(1.0);
const Angle kRounding = Angle::fromDegrees(1e-9);
const Angle kBeyond = Angle::fromDegrees(3600.0);

QString degrees(Angle angle)
{
    return toQString(formatFixed(angle.degrees(), 1)) + QStringLiteral("°");
}

TravelRange common(const TravelRange& a, const TravelRange& b)
{
    return {.min = std::max(a.min, b.min), .max = std::min(a.max, b.max)};
}

TravelRange shifted(const TravelRange& range, Angle by)
{
    return {.min = range.min + by, .max = range.max + by};
}

// More than an edge in common.
bool overlap(const TravelRange& a, const TravelRange& b)
{
    return a.max > b.min + kRounding && a.min < b.max - kRounding;
}

bool overlap(const AxisBox& a, const AxisBox& b)
{
    return overlap(a.azimuth, b.azimuth) && overlap(a.elevation, b.elevation);
}

bool within(const TravelRange& inner, const TravelRange& outer)
{
    return inner.min >= outer.min - kRounding && inner.max <= outer.max + kRounding;
}

// Takes away from `range` what lies beyond `obstacle`, which is beside `kept`.
void cut(TravelRange& range, const TravelRange& kept, const TravelRange& obstacle)
{
    if (obstacle.min >= kept.max - kRounding) {
        range.max = std::min(range.max, obstacle.min);
    } else if (obstacle.max <= kept.min + kRounding) {
        range.min = std::max(range.min, obstacle.max);
    }
}

TravelRange hull(const TravelRange& a, const TravelRange& b)
{
    return {.min = std::min(a.min, b.min), .max = std::max(a.max, b.max)};
}

// Does `after` begin where `before` ends, or hardly later?
bool follows(const TravelRange& before, const TravelRange& after)
{
    return after.min >= before.max - kRounding && after.min <= before.max + kSlit;
}

// What closes the way between two boxes of which the second follows the first along one axis.
std::optional<AxisBox> slitBetween(const AxisBox& a, const AxisBox& b)
{
    AxisBox slit{.azimuth = common(a.azimuth, b.azimuth), .elevation = common(a.elevation, b.elevation)};
    if (follows(a.azimuth, b.azimuth) && slit.elevation.min < slit.elevation.max - kRounding) {
        slit.azimuth = hull(a.azimuth, b.azimuth);
        return slit;
    }
    if (follows(a.elevation, b.elevation) && slit.azimuth.min < slit.azimuth.max - kRounding) {
        slit.elevation = hull(a.elevation, b.elevation);
        return slit;
    }
    return std::nullopt;
}

}  // namespace

AxisBox AxisBox::at(const AxisPosition& place)
{
    return {.azimuth = {place.azimuth, place.azimuth}, .elevation = {place.elevation, place.elevation}};
}

AxisBox AxisBox::between(const AxisPosition& a, const AxisPosition& b)
{
    return {.azimuth = {std::min(a.azimuth, b.azimuth), std::max(a.azimuth, b.azimuth)},
            .elevation = {std::min(a.elevation, b.elevation), std::max(a.elevation, b.elevation)}};
}

PermittedRegion::PermittedRegion(const Region& region, const TravelRange& azimuthTravel,
                                 const TravelRange& elevationTravel)
    : m_ranges{.azimuth = common(region.azimuth, azimuthTravel),
               .elevation = common(region.elevation, elevationTravel)},
      m_skyline(region.horizon),
      m_keepOuts(region.keepOuts)
{
    for (std::size_t i = 0; i < m_keepOuts.size(); ++i) {
        layOut(m_keepOuts[i], i);
        for (const KeepOut& standing : standingOnHorizon(m_keepOuts[i], m_skyline)) {
            layOut(standing, i);
        }
    }
    closeSlits();
    closeSlits();  // where three meet, between what the first round closed
    dropCovered();
}

// On every turn that can be reached, upright and over the top. One that goes all round and up to the zenith is one box
// across it: else the zenith in its middle would be an edge.
void PermittedRegion::layOut(const KeepOut& keepOut, std::size_t index)
{
    const Angle top = std::min(keepOut.elevationMax, 90_deg);
    const Angle width = (keepOut.azimuthTo - keepOut.azimuthFrom).wrapped360();
    const bool allRound = abs(keepOut.azimuthTo - keepOut.azimuthFrom) >= kFullTurn - kRounding;
    if (allRound) {
        const TravelRange everywhere{m_ranges.azimuth.min - kFullTurn, m_ranges.azimuth.max + kFullTurn};
        const Angle high = top >= 90_deg - kRounding ? 180_deg - keepOut.elevationMin : top;
        add({.azimuth = everywhere, .elevation = {keepOut.elevationMin, high}}, index);
        if (high == top) {
            add({.azimuth = everywhere, .elevation = {180_deg - top, 180_deg - keepOut.elevationMin}}, index);
        }
        return;
    }
    const TravelRange upright{keepOut.azimuthFrom, keepOut.azimuthFrom + width};
    const double first = std::floor((m_ranges.azimuth.min - upright.max) / kFullTurn) - 1.0;
    const double last = std::ceil((m_ranges.azimuth.max - upright.min) / kFullTurn);
    for (double turn = first; turn <= last; turn += 1.0) {
        const TravelRange azimuths = shifted(upright, turn * kFullTurn);
        add({.azimuth = azimuths, .elevation = {keepOut.elevationMin, top}}, index);
        add({.azimuth = shifted(azimuths, 180_deg), .elevation = {180_deg - top, 180_deg - keepOut.elevationMin}},
            index);
    }
}

// What reaches the end of a range goes on beyond it.
void PermittedRegion::add(AxisBox box, std::size_t index)
{
    const bool empty = box.azimuth.max - box.azimuth.min <= 2.0 * kRounding ||
                       box.elevation.max - box.elevation.min <= 2.0 * kRounding;
    const auto extend = [](TravelRange& side, const TravelRange& range) {
        side.min = side.min <= range.min + kSlit ? std::min(side.min, range.min - kBeyond) : side.min;
        side.max = side.max >= range.max - kSlit ? std::max(side.max, range.max + kBeyond) : side.max;
    };
    const bool reachable = box.azimuth.max > m_ranges.azimuth.min && box.azimuth.min < m_ranges.azimuth.max &&
                           box.elevation.max > m_ranges.elevation.min && box.elevation.min < m_ranges.elevation.max;
    if (!empty && reachable) {
        extend(box.azimuth, m_ranges.azimuth);
        extend(box.elevation, m_ranges.elevation);
        m_boxes.push_back(box);
        m_owner.push_back(index);
    }
}

void PermittedRegion::closeSlits()
{
    const std::size_t count = m_boxes.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) {
            if (const auto slit = slitBetween(m_boxes[i], m_boxes[j])) {
                m_boxes.push_back(*slit);
                m_owner.push_back(m_owner[i]);
            }
        }
    }
}

// Boxes that lie in another one say nothing.
void PermittedRegion::dropCovered()
{
    for (std::size_t i = m_boxes.size(); i-- > 0;) {
        const auto covers = [&](const AxisBox& other) {
            return &other != &m_boxes[i] && within(m_boxes[i].azimuth, other.azimuth) &&
                   within(m_boxes[i].elevation, other.elevation);
        };
        if (std::ranges::any_of(m_boxes, covers)) {
            m_boxes.erase(m_boxes.begin() + static_cast<std::ptrdiff_t>(i));
            m_owner.erase(m_owner.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
}

Angle PermittedRegion::floor(const TravelRange& azimuths) const
{
    return m_skyline.highest(azimuths.min, azimuths.max);
}

Angle PermittedRegion::ceiling(const TravelRange& azimuths) const
{
    return 180_deg - m_skyline.highest(azimuths.min + 180_deg, azimuths.max + 180_deg);
}

bool PermittedRegion::permits(const AxisBox& box) const
{
    if (!within(box.azimuth, m_ranges.azimuth) || !within(box.elevation, m_ranges.elevation)) {
        return false;
    }
    if (std::ranges::any_of(m_boxes, [&](const AxisBox& keepOut) { return overlap(box, keepOut); })) {
        return false;
    }
    if (m_skyline.empty()) {
        return true;
    }
    const bool upright = box.elevation.min <= 90_deg;
    const bool overTheTop = box.elevation.max > 90_deg;
    return (!upright || floor(box.azimuth) <= box.elevation.min + kRounding) &&
           (!overTheTop || ceiling(box.azimuth) >= box.elevation.max - kRounding);
}

const KeepOut* PermittedRegion::keepOutAt(const AxisPosition& place) const
{
    const auto box = std::ranges::find_if(
        m_boxes, [at = AxisBox::at(place)](const AxisBox& keepOut) { return overlap(at, keepOut); });
    return box == m_boxes.end() ? nullptr : &m_keepOuts[m_owner[static_cast<std::size_t>(box - m_boxes.begin())]];
}

std::string PermittedRegion::reason(const AxisPosition& place) const
{
    const auto outside = [](const QString& sentence, Angle angle, const TravelRange& range) {
        return sentence.arg(degrees(angle), degrees(range.min), degrees(range.max)).toStdString();
    };
    if (permits(place)) {
        return {};
    }
    if (!within(AxisBox::at(place).azimuth, m_ranges.azimuth)) {
        return outside(Text::tr("azimuth %1 outside limits %2…%3"), place.azimuth, m_ranges.azimuth);
    }
    if (!within(AxisBox::at(place).elevation, m_ranges.elevation)) {
        return outside(Text::tr("elevation %1 outside limits %2…%3"), place.elevation, m_ranges.elevation);
    }
    if (const KeepOut* const keepOut = keepOutAt(place)) {
        return Text::tr("azimuth %1 elevation %2 is in the keep-out \"%3\"")
            .arg(degrees(place.azimuth), degrees(place.elevation), toQString(keepOut->name))
            .toStdString();
    }
    const SkyPointing beam = MountModel::toSky(place);
    return Text::tr("elevation %1 below the horizon %2 at azimuth %3")
        .arg(degrees(beam.elevation), degrees(m_skyline.at(beam.azimuth)), degrees(beam.azimuth))
        .toStdString();
}

std::string PermittedRegion::obstacle(const AxisPosition& place) const
{
    if (permits(place)) {
        return {};
    }
    if (!within(AxisBox::at(place).azimuth, m_ranges.azimuth)) {
        return Text::tr("the azimuth limit %1").arg(degrees(m_ranges.azimuth.clamped(place.azimuth))).toStdString();
    }
    if (!within(AxisBox::at(place).elevation, m_ranges.elevation)) {
        return Text::tr("the elevation limit %1")
            .arg(degrees(m_ranges.elevation.clamped(place.elevation)))
            .toStdString();
    }
    const KeepOut* const keepOut = keepOutAt(place);
    return (keepOut != nullptr ? Text::tr("the keep-out \"%1\"").arg(toQString(keepOut->name))
                               : Text::tr("the horizon"))
        .toStdString();
}

TravelRange PermittedRegion::azimuthsAround(const AxisBox& box) const
{
    TravelRange range = m_ranges.azimuth;
    for (const AxisBox& keepOut : m_boxes) {
        if (overlap(keepOut.elevation, box.elevation)) {
            cut(range, box.azimuth, keepOut.azimuth);
        }
    }
    const auto stayAbove = [&](Angle height, Angle turned) {
        range.max = std::min(range.max, box.azimuth.max + m_skyline.clearClockwise(box.azimuth.max + turned, height));
        range.min =
            std::max(range.min, box.azimuth.min - m_skyline.clearAnticlockwise(box.azimuth.min + turned, height));
    };
    if (!m_skyline.empty() && box.elevation.min <= 90_deg) {
        stayAbove(box.elevation.min, 0_deg);
    }
    if (!m_skyline.empty() && box.elevation.max > 90_deg) {
        stayAbove(180_deg - box.elevation.max, 180_deg);
    }
    return hull(range, box.azimuth);
}

TravelRange PermittedRegion::elevationsAround(const AxisBox& box) const
{
    TravelRange range = m_ranges.elevation;
    for (const AxisBox& keepOut : m_boxes) {
        if (overlap(keepOut.azimuth, box.azimuth)) {
            cut(range, box.elevation, keepOut.elevation);
        }
    }
    if (!m_skyline.empty()) {
        range.min = std::max(range.min, floor(box.azimuth));
        range.max = std::min(range.max, ceiling(box.azimuth));
    }
    return hull(range, box.elevation);
}

}  // namespace boresight::pointing
