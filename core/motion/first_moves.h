// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/profile.h"
#include "core/units/sky.h"

#include <optional>

// Before a person has confirmed which way each axis turns, the mount is moved by hand only, by a jog or by a client's
// "M": slowly, and no farther than a small way from where the first such motion began. A wrong sign then shows without
// harm. Pure.
namespace boresight {

class FirstMoves
{
public:
    static constexpr Angle kFarthest = Angle::fromDegrees(1.9);  // 2°, less what a tick adds

    // May the axes, which are at `place`, be jogged so? `rest` is where they would stop from such a motion.
    Result<> admits(const AxisRates& rates, const AxisPosition& place, const AxisPosition& rest);
    // An axis that moves so, braking now, would stop beyond the small way and moves farther out. The way back
    // is no such motion, nor does an axis at its end keep the other from moving.
    [[nodiscard]] bool exceeded(const AxisRates& rates, const AxisPosition& rest) const;

private:
    std::optional<AxisPosition> m_origin;
};

// Where an axis that moves so stops when it brakes now, by its own limits.
[[nodiscard]] Angle restingPlace(const tracking::Setpoint& now, const tracking::MotionLimits& limits);

}  // namespace boresight
