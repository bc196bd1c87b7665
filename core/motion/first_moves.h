// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/profile.h"
#include "core/units/sky.h"

#include <optional>

// Limits the motion of the mount until a person has confirmed the direction of each axis. Until then it is moved only
// by hand, by a jog or by "M" of a client: slowly, and only a small way from where the first such motion began. A wrong
// sign then shows without harm. Pure.
namespace boresight {

class FirstMoves
{
public:
    static constexpr Angle kFarthest = Angle::fromDegrees(1.9);  // 2° minus the way of one tick

    // Whether the axes at `place` may be jogged at `rates`. `rest`: where they would stop from this motion.
    Result<> admits(const AxisRates& rates, const AxisPosition& place, const AxisPosition& rest);
    // True if an axis moves outwards and would stop beyond the small way if it braked now. The way back is not
    // affected. An axis at its end does not keep the other axis from moving.
    [[nodiscard]] bool exceeded(const AxisRates& rates, const AxisPosition& rest) const;

private:
    std::optional<AxisPosition> m_origin;
};

// Where an axis with this set-point stops if it brakes now, within its limits.
[[nodiscard]] Angle restingPlace(const tracking::Setpoint& now, const tracking::MotionLimits& limits);

}  // namespace boresight
