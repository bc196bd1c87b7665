// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/axis_setpoints.h"

#include <optional>

// Whether the cable of the azimuth has room for a whole path, on which wraps, and how long an unwrap takes. Pure;
// mechanical angles.
namespace boresight::tracking {

// The permitted numbers of whole turns, from `first` to `last`. None if first > last.
struct WholeTurns
{
    int first = 0;
    int last = -1;

    [[nodiscard]] bool any() const { return first <= last; }
};

// The arc that a path sweeps. Each place is taken on the turn nearest to the previous place.
class SweptArc
{
public:
    void add(Angle azimuth);

    // By how many turns the arc can be shifted so that all of it lies inside the range. None if the arc has no place.
    [[nodiscard]] WholeTurns turnsInside(const TravelRange& range) const;

private:
    std::optional<Angle> m_last;
    TravelRange m_swept;
};

// The time of one turn from standstill to standstill, including ramps. The jerk adds less than a second.
[[nodiscard]] Seconds fullTurnTime(const MotionLimits& limits);

}  // namespace boresight::tracking
