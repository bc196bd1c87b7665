// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <optional>

// The ends of one axis that are closed to its set-points, wherever they are: they move on only the other way. Pure.
namespace boresight {

struct ClosedEnds
{
    bool lower = false;
    bool upper = false;

    bool operator==(const ClosedEnds&) const = default;
};

class AxisEnds
{
public:
    void close(const ClosedEnds& ends);
    // Once per step: `rest` is the range that the set-point passes until it would stop now. A set-point that moves away
    // takes the closed end with it, so it does not come back.
    void keep(const TravelRange& rest);
    // The set-point begins at another place.
    void forget() { m_lowest = m_highest = std::nullopt; }

    [[nodiscard]] bool isClosed(bool isUpper) const { return isUpper ? m_closed.upper : m_closed.lower; }
    [[nodiscard]] bool isAnyClosed() const { return m_closed != ClosedEnds{}; }
    // The part of a room that the set-points may reach.
    [[nodiscard]] TravelRange openPart(const TravelRange& room) const;

private:
    ClosedEnds m_closed;
    std::optional<Angle> m_lowest;  // the set-points may reach; empty: as far as the room
    std::optional<Angle> m_highest;
};

}  // namespace boresight
