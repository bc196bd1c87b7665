// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/time_optimal.h"

#include <optional>
#include <span>
#include <vector>

// The way of one axis through a corridor that changes with time, within its speed and acceleration. Exact: a way is
// found if there is one whose acceleration is constant between the moments. Radians and seconds, pure.
namespace boresight::plan {

// One moment of the corridor: where the axis may be, and where it should be.
struct Gate
{
    double seconds = 0.0;
    double low = 0.0;
    double high = 0.0;
    tracking::MotionState wish;
};

// The state in which the way begins and ends. Empty: any state inside the corridor.
struct WayEnds
{
    std::optional<tracking::MotionState> first;
    std::optional<tracking::MotionState> last;
};

// One state for each gate, as close to the wishes as a look at one gate after the other allows. Empty: there is no way.
[[nodiscard]] std::optional<std::vector<tracking::MotionState>> wayThrough(std::span<const Gate> gates,
                                                                           const WayEnds& ends,
                                                                           const tracking::MotionBounds& bounds);

// Whether there is a way.
[[nodiscard]] bool hasWay(std::span<const Gate> gates, const WayEnds& ends, const tracking::MotionBounds& bounds);

}  // namespace boresight::plan
