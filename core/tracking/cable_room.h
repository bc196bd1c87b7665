// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/axis_profile.h"

#include <optional>

// Whether the cable of the azimuth has room for all of a path, on which wraps, and how long one is gone back. Pure;
// mechanical angles.
namespace boresight::tracking {

// By how many whole turns: from `first` to `last`. None if first > last.
struct WholeTurns
{
    int first = 0;
    int last = -1;

    [[nodiscard]] bool any() const { return first <= last; }
};

// What a path sweeps: each place is taken on the turn nearest to the one before it.
class SweptArc
{
public:
    void add(Angle azimuth);

    // By which turns all of the arc can be moved and lies in the range. Without a place: none.
    [[nodiscard]] WholeTurns turnsInside(const TravelRange& range) const;

private:
    std::optional<Angle> m_last;
    TravelRange m_swept;
};

// One turn from standstill to standstill, ramps included. The jerk adds a part of a second.
[[nodiscard]] Seconds fullTurnTime(const MotionLimits& limits);

}  // namespace boresight::tracking
