// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/each_step.h"

#include "core/rotator_box/box_interlock.h"
#include "core/rotator_box/switched_axis.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

// The target is this far ahead of the set-point, because the next target comes half a second later.
constexpr Seconds kAhead{0.6};

// The nearest position that the rotator can be sent to. For an angle inside the travel, the result is inside, too.
Angle onStep(const TravelRange& travel, Angle angle, Angle step)
{
    const TravelRange steps = stepsIn(travel, step);
    const bool isInside = angle >= travel.min && angle <= travel.max;
    return isInside ? std::clamp(inSteps(angle, step), steps.min, steps.max) : inSteps(angle, step);
}

}  // namespace

Angle inSteps(Angle angle, Angle step)
{
    return step > Angle{} ? step * std::round(angle / step) : angle;
}

Angle eachStep(const tracking::Setpoint& setpoint, const profile::AxisSettings& axis, const std::optional<Angle>& place,
               Angle step)
{
    const double rate = setpoint.rate.degrees();
    const double stopping = rate * rate / (2.0 * axis.limits.acceleration.degrees());
    const double ahead = std::min(std::abs(rate) * kAhead.count(), stopping);
    const Angle aim = setpoint.position + Angle::fromDegrees(std::copysign(ahead, rate));
    constexpr Angle kFarthest = SwitchedAxis::kFarthest;
    return onStep(axis.geometry.travel, place ? std::clamp(aim, *place - kFarthest, *place + kFarthest) : aim, step);
}

}  // namespace boresight
