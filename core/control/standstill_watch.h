// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mount/mount_report.h"
#include "core/units/sky.h"

#include <array>
#include <deque>

// Whether an axis moves, judged by the angles that it reported during the last second. The rate that a drive reports
// is no evidence near standstill: behind a low gear, its noise is larger than the rate of a slow motion. Station
// thread only.
namespace boresight {

class StandstillWatch
{
public:
    // Once per tick.
    void look(Axis axis, const AxisReport& report);
    // The angles have another zero from this call on.
    void forget() { m_places = {}; }
    // True for every motion faster than the Sun, except near the zenith.
    [[nodiscard]] bool moves(Axis axis) const;
    // The axis was seen for long enough, and it does not move.
    [[nodiscard]] bool stands(Axis axis) const;

private:
    struct Place
    {
        SteadyTime time;
        Angle angle;
    };
    struct Places
    {
        std::deque<Place> seen;  // by time
        SteadyTime first{};      // of all that were seen without a gap
    };

    std::array<Places, 2> m_places;
};

}  // namespace boresight
