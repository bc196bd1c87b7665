// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/time_optimal.h"

#include <vector>

// All states of one axis, position and rate, that it can have at one moment: a convex polygon. With limits of speed and
// acceleration and bounds of the position such a set stays convex, so the steps are exact. Radians and seconds, pure.
namespace boresight::plan {

class StateSet
{
public:
    [[nodiscard]] static StateSet only(const tracking::MotionState& state);
    [[nodiscard]] static StateSet box(double low, double high, double speed);

    [[nodiscard]] bool empty() const { return m_corners.empty(); }
    [[nodiscard]] bool contains(const tracking::MotionState& state) const;
    // All states `time` later, with any constant acceleration up to the limit.
    [[nodiscard]] StateSet later(double time, double acceleration) const;
    // The states within bounds of the position and the rate.
    [[nodiscard]] StateSet within(double low, double high, double speed) const;
    // The state of the set closest to another state. A difference of the rate counts as that of the position in `time`.
    [[nodiscard]] tracking::MotionState closest(const tracking::MotionState& wish, double time) const;
    // A state of the set from which a constant acceleration leads to `to` after `time`: of all these, the one closest
    // to `wish`.
    [[nodiscard]] tracking::MotionState before(const tracking::MotionState& to, double time, double acceleration,
                                               const tracking::MotionState& wish) const;

private:
    explicit StateSet(std::vector<tracking::MotionState> corners) : m_corners(std::move(corners)) {}

    std::vector<tracking::MotionState> m_corners;  // counterclockwise, with the rate upwards
};

}  // namespace boresight::plan
