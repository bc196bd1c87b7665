// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/axis_ends.h"

#include <algorithm>

namespace boresight {

void AxisEnds::close(const ClosedEnds& ends)
{
    m_closed = ends;
    m_lowest = ends.lower ? m_lowest : std::nullopt;
    m_highest = ends.upper ? m_highest : std::nullopt;
}

void AxisEnds::keep(const TravelRange& rest)
{
    if (m_closed.lower) {
        m_lowest = std::max(m_lowest.value_or(rest.min), rest.min);
    }
    if (m_closed.upper) {
        m_highest = std::min(m_highest.value_or(rest.max), rest.max);
    }
}

TravelRange AxisEnds::openPart(const TravelRange& room) const
{
    const Angle max = m_highest ? std::max(std::min(room.max, *m_highest), room.min) : room.max;
    return {.min = m_lowest ? std::min(std::max(room.min, *m_lowest), max) : room.min, .max = max};
}

}  // namespace boresight
