// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/permitted_region.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/pointing/axis_image.h"
#include "core/pointing/ranges.h"
#include "core/pointing/slits.h"
#include "core/pointing/xy_image.h"
#include "core/units/direction_text.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace boresight::pointing {

namespace {

TravelRange shifted(const TravelRange& range, Angle by)
{
    return {.min = range.min + by, .max = range.max + by};
}

// True if they share more than an edge.
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

// Removes from `range` everything on the far side of `obstacle`, which lies beside `kept`.
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

// True if `after` begins where `before` ends, or within the width of a slit.
bool follows(const TravelRange& before, const TravelRange& after)
{
    return after.min >= before.max - kRounding && after.min <= before.max + kSlit;
}

// The box that closes the slit between two boxes, where `b` follows `a` along one axis.
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

// The horizon as a line in axis angles. X and Y have none: at one X the beam may be below the horizon between two
// places above it.
Skyline lineOf(const Skyline& horizon, const PointingModel& pointing, Side side)
{
    return Skyline(pointing.isXY() ? std::vector<HorizonPoint>{} : AxisImage(pointing).of(horizon, side));
}

}  // namespace

PermittedRegion::PermittedRegion(const Region& region, const TravelRange& azimuthTravel,
                                 const TravelRange& elevationTravel, const PointingModel& pointing)
    : m_pointing(pointing),
      m_ranges{.azimuth = common(region.azimuth, azimuthTravel),
               .elevation = common(region.elevation, elevationTravel)},
      m_horizon(region.horizon),
      m_upright(lineOf(m_horizon, pointing, Side::Upright)),
      m_overTheTop(lineOf(m_horizon, pointing, Side::OverTheTop)),
      m_keepOuts(region.keepOuts)
{
    if (pointing.isXY()) {
        layOutXY();
    } else {
        layOutAzimuthElevation();
    }
    closeSlits();
    dropCovered();  // before the next round, which compares all pairs
    closeSlits();   // slits where three boxes meet, next to the boxes that the first round added
    dropCovered();
}

void PermittedRegion::layOutAzimuthElevation()
{
    const AxisImage image(m_pointing);
    for (std::size_t i = 0; i < m_keepOuts.size(); ++i) {
        std::vector<KeepOut> parts = standingOnHorizon(m_keepOuts[i], m_horizon);
        parts.insert(parts.begin(), m_keepOuts[i]);
        for (const KeepOut& part : parts) {
            for (const AxisBox& box : image.of(part)) {
                layOut(box, i);
            }
        }
    }
    for (const AxisBox& cap : image.capOf(m_horizon)) {
        layOut(cap, m_keepOuts.size());
    }
}

// Keep-outs of one name, such as the band of the Sun, become one shape with few boxes.
void PermittedRegion::layOutXY()
{
    const XYImage image(m_ranges, m_pointing.terms().geometry.xAxis);
    for (std::size_t i = 0; i < m_keepOuts.size(); ++i) {
        const auto isNamed = [&](const KeepOut& one) { return one.name == m_keepOuts[i].name; };
        if (std::any_of(m_keepOuts.begin(), m_keepOuts.begin() + static_cast<std::ptrdiff_t>(i), isNamed)) {
            continue;
        }
        std::vector<KeepOut> parts;
        for (const KeepOut& one : m_keepOuts) {
            if (isNamed(one)) {
                const std::vector<KeepOut> standing = standingOnHorizon(one, m_horizon);
                parts.push_back(one);
                parts.insert(parts.end(), standing.begin(), standing.end());
            }
        }
        for (const AxisBox& box : image.of(parts)) {
            add(box, i);
        }
    }
    for (const AxisBox& box : image.of(m_horizon)) {
        add(box, m_keepOuts.size());
    }
}

// Adds the box on every turn that the axis can reach.
void PermittedRegion::layOut(const AxisBox& box, std::size_t index)
{
    const TravelRange& azimuth = m_ranges.azimuth;
    if (box.azimuth.max - box.azimuth.min >= kFullTurn) {
        add({.azimuth = {azimuth.min - kFullTurn, azimuth.max + kFullTurn}, .elevation = box.elevation}, index);
        return;
    }
    const double first = std::floor((azimuth.min - box.azimuth.max) / kFullTurn);
    const double last = std::ceil((azimuth.max - box.azimuth.min) / kFullTurn);
    for (double turn = first; turn <= last; turn += 1.0) {
        add({.azimuth = shifted(box.azimuth, turn * kFullTurn), .elevation = box.elevation}, index);
    }
}

// A box that reaches the end of a range is extended beyond that end. Otherwise the axes could pass below a mast that
// begins at 0°, on a mount whose lean puts its own 0° lower there.
void PermittedRegion::add(AxisBox box, std::size_t index)
{
    const bool empty = box.azimuth.max - box.azimuth.min <= 2.0 * kRounding ||
                       box.elevation.max - box.elevation.min <= 2.0 * kRounding;
    const Angle slit = kSlit + m_pointing.skew();
    const auto extend = [slit](TravelRange& side, const TravelRange& range) {
        side.min = side.min <= range.min + slit ? std::min(side.min, range.min - kBeyond) : side.min;
        side.max = side.max >= range.max - slit ? std::max(side.max, range.max + kBeyond) : side.max;
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

// Removes boxes that lie completely inside another box.
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
    return m_upright.highest(azimuths.min, azimuths.max);
}

Angle PermittedRegion::ceiling(const TravelRange& azimuths) const
{
    return 180_deg - m_overTheTop.highest(azimuths.min + 180_deg, azimuths.max + 180_deg);
}

bool PermittedRegion::permits(const AxisBox& box) const
{
    if (!within(box.azimuth, m_ranges.azimuth) || !within(box.elevation, m_ranges.elevation)) {
        return false;
    }
    if (std::ranges::any_of(m_boxes, [&](const AxisBox& keepOut) { return overlap(box, keepOut); })) {
        return false;
    }
    const bool above = m_upright.peak() <= box.elevation.min;
    const bool below = m_overTheTop.peak() <= 180_deg - box.elevation.max;
    return (above || floor(box.azimuth) <= box.elevation.min + kRounding) &&
           (below || ceiling(box.azimuth) >= box.elevation.max - kRounding);
}

const KeepOut* PermittedRegion::keepOutAt(const AxisPosition& place) const
{
    const auto box = std::ranges::find_if(
        m_boxes, [at = AxisBox::at(place)](const AxisBox& keepOut) { return overlap(at, keepOut); });
    if (box == m_boxes.end()) {
        return nullptr;
    }
    const std::size_t owner = m_owner[static_cast<std::size_t>(box - m_boxes.begin())];
    return owner < m_keepOuts.size() ? &m_keepOuts[owner] : nullptr;
}

QString PermittedRegion::reason(const AxisPosition& place) const
{
    const auto outside = [](const QString& sentence, Angle angle, const TravelRange& range) {
        return sentence.arg(degreesText(angle), degreesText(range.min), degreesText(range.max));
    };
    if (permits(place)) {
        return {};
    }
    if (!within(AxisBox::at(place).azimuth, m_ranges.azimuth)) {
        return outside(m_pointing.isXY() ? Text::tr("X axis %1 outside limits %2…%3")
                                         : Text::tr("azimuth axis %1 outside limits %2…%3"),
                       place.azimuth, m_ranges.azimuth);
    }
    if (!within(AxisBox::at(place).elevation, m_ranges.elevation)) {
        return outside(m_pointing.isXY() ? Text::tr("Y axis %1 outside limits %2…%3")
                                         : Text::tr("elevation %1 outside limits %2…%3"),
                       place.elevation, m_ranges.elevation);
    }
    return trueReason(place);
}

// In terms of the drawn horizon and keep-outs: true directions without turns.
QString PermittedRegion::trueReason(const AxisPosition& place) const
{
    if (const KeepOut* const keepOut = keepOutAt(place)) {
        return Text::tr("%1 lies in keep-out \"%2\"").arg(beamText(upright(beamAt(place))), toQString(keepOut->name));
    }
    const SkyPointing beam = upright(beamAt(place));
    if (beam.elevation >= m_horizon.at(beam.azimuth)) {
        return Text::tr("%1 lies too close to the horizon (%2)")
            .arg(beamText(beam), degreesText(m_horizon.at(beam.azimuth)));
    }
    return Text::tr("%1 lies below the horizon (%2)").arg(beamText(beam), degreesText(m_horizon.at(beam.azimuth)));
}

QString PermittedRegion::obstacle(const AxisPosition& place) const
{
    if (permits(place)) {
        return {};
    }
    if (!within(AxisBox::at(place).azimuth, m_ranges.azimuth)) {
        return (m_pointing.isXY() ? Text::tr("the X axis limit %1") : Text::tr("the azimuth axis limit %1"))
            .arg(degreesText(m_ranges.azimuth.clamped(place.azimuth)));
    }
    if (!within(AxisBox::at(place).elevation, m_ranges.elevation)) {
        return (m_pointing.isXY() ? Text::tr("the Y axis limit %1") : Text::tr("the elevation limit %1"))
            .arg(degreesText(m_ranges.elevation.clamped(place.elevation)));
    }
    const KeepOut* const keepOut = keepOutAt(place);
    return keepOut != nullptr ? Text::tr("the keep-out \"%1\"").arg(toQString(keepOut->name)) : Text::tr("the horizon");
}

TravelRange PermittedRegion::azimuthsAround(const AxisBox& box) const
{
    TravelRange range = m_ranges.azimuth;
    for (const AxisBox& keepOut : m_boxes) {
        if (overlap(keepOut.elevation, box.elevation)) {
            cut(range, box.azimuth, keepOut.azimuth);
        }
    }
    const auto stayAbove = [&](const Skyline& line, Angle height, Angle turned) {
        range.max = std::min(range.max, box.azimuth.max + line.clearClockwise(box.azimuth.max + turned, height));
        range.min = std::max(range.min, box.azimuth.min - line.clearAnticlockwise(box.azimuth.min + turned, height));
    };
    stayAbove(m_upright, box.elevation.min, 0_deg);
    stayAbove(m_overTheTop, 180_deg - box.elevation.max, 180_deg);
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
    if (hasHorizonLine()) {
        range.min = std::max(range.min, floor(box.azimuth));
        range.max = std::min(range.max, ceiling(box.azimuth));
    }
    return hull(range, box.elevation);
}

}  // namespace boresight::pointing
