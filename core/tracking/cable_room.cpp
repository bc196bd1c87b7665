// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/cable_room.h"

#include <algorithm>
#include <cmath>

namespace boresight::tracking {

void SweptArc::add(Angle azimuth)
{
    const Angle place = m_last ? azimuth.nearestTo(*m_last) : azimuth;
    m_swept =
        m_last ? TravelRange{std::min(m_swept.min, place), std::max(m_swept.max, place)} : TravelRange{place, place};
    m_last = place;
}

WholeTurns SweptArc::turnsInside(const TravelRange& range) const
{
    if (!m_last) {
        return {};
    }
    return {.first = static_cast<int>(std::ceil((range.min - m_swept.min).turns())),
            .last = static_cast<int>(std::floor((range.max - m_swept.max).turns()))};
}

Seconds fullTurnTime(const MotionLimits& limits)
{
    return Seconds(360.0 / limits.speed.degrees() + limits.speed.degrees() / limits.acceleration.degrees());
}

}  // namespace boresight::tracking
