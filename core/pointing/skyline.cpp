// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/skyline.h"

#include "core/pointing/ranges.h"

#include <algorithm>

namespace boresight::pointing {

namespace {

const Angle kNowhere = Angle::fromDegrees(-3600.0);
const Angle kEverywhere = Angle::fromDegrees(3600.0);

}  // namespace

Skyline::Skyline(const std::vector<HorizonPoint>& points) : m_highest(kNowhere)
{
    std::vector<HorizonPoint> sorted;
    for (const HorizonPoint& point : points) {
        sorted.push_back({.azimuth = point.azimuth.wrapped360(), .elevation = point.elevation});
        m_highest = std::max(m_highest, point.elevation);
    }
    std::ranges::sort(sorted, [](const HorizonPoint& a, const HorizonPoint& b) {
        return a.azimuth < b.azimuth || (a.azimuth == b.azimuth && a.elevation > b.elevation);
    });
    const auto same = std::ranges::unique(sorted, {}, &HorizonPoint::azimuth);
    sorted.erase(same.begin(), same.end());
    m_count = sorted.size();
    for (const Angle turn : {-kFullTurn, 0_deg, kFullTurn}) {
        for (const HorizonPoint& point : sorted) {
            m_points.push_back({.azimuth = point.azimuth + turn, .elevation = point.elevation});
        }
    }
}

// `azimuth` is in [0°, 360°).
std::size_t Skyline::firstAfter(Angle azimuth) const
{
    const auto after = std::ranges::upper_bound(m_points, azimuth, {}, &HorizonPoint::azimuth);
    return static_cast<std::size_t>(after - m_points.begin());
}

Angle Skyline::between(std::size_t right, Angle azimuth) const
{
    const HorizonPoint& a = m_points[right - 1];
    const HorizonPoint& b = m_points[right];
    return a.elevation + (b.elevation - a.elevation) * ((azimuth - a.azimuth) / (b.azimuth - a.azimuth));
}

Angle Skyline::at(Angle azimuth) const
{
    if (empty()) {
        return kNowhere;
    }
    const Angle wrapped = azimuth.wrapped360();
    return between(firstAfter(wrapped), wrapped);
}

Angle Skyline::highest(Angle from, Angle to) const
{
    if (empty() || to - from >= kFullTurn) {
        return m_highest;
    }
    const Angle begin = from.wrapped360();
    const Angle end = begin + (to - from);
    std::size_t next = firstAfter(begin);
    Angle highest = std::max(between(next, begin), at(to));
    for (; next < m_points.size() && m_points[next].azimuth < end; ++next) {
        highest = std::max(highest, m_points[next].elevation);
    }
    return highest;
}

Angle Skyline::clearClockwise(Angle from, Angle height) const
{
    if (m_highest <= height) {
        return kEverywhere;
    }
    const Angle begin = from.wrapped360();
    std::size_t next = firstAfter(begin);
    HorizonPoint last{.azimuth = begin, .elevation = std::min(between(next, begin), height)};
    while (m_points[next].elevation <= height) {
        last = m_points[next++];
    }
    const HorizonPoint& high = m_points[next];
    const double part = (height - last.elevation) / (high.elevation - last.elevation);
    return last.azimuth + (high.azimuth - last.azimuth) * part - begin;
}

Angle Skyline::clearAnticlockwise(Angle from, Angle height) const
{
    if (m_highest <= height) {
        return kEverywhere;
    }
    const Angle begin = from.wrapped360();
    std::size_t next = firstAfter(begin);
    HorizonPoint last{.azimuth = begin, .elevation = std::min(between(next, begin), height)};
    while (m_points[next - 1].elevation <= height) {
        last = m_points[--next];
    }
    const HorizonPoint& high = m_points[next - 1];
    const double part = (height - last.elevation) / (high.elevation - last.elevation);
    return begin - (last.azimuth + (high.azimuth - last.azimuth) * part);
}

}  // namespace boresight::pointing
