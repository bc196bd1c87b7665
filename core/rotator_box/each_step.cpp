// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/each_step.h"

#include "core/rotator_box/switched_axis.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

// The target is this far ahead of the set-point, because the next target comes half a second later.
constexpr Seconds kAhead{0.6};
constexpr Angle kRoundingOfSteps = Angle::fromDegrees(1e-6);

bool isInside(const TravelRange& range, Angle angle)
{
    return angle <= range.max + kRoundingOfSteps && angle >= range.min - kRoundingOfSteps;
}

}  // namespace

Angle inSteps(Angle angle, Angle step)
{
    return step > Angle{} ? step * std::round(angle / step) : angle;
}

Angle stepInside(Angle angle, Angle step, const TravelRange& within)
{
    const Angle nearest = inSteps(angle, step);
    const Angle inwards = nearest > within.max + kRoundingOfSteps   ? nearest - step
                          : nearest < within.min - kRoundingOfSteps ? nearest + step
                                                                    : nearest;
    return isInside(within, inwards) ? inwards : nearest;
}

void EachStep::begin(Angle place, Angle step)
{
    m_target = inSteps(place, step);
    m_way = 0.0;
}

bool EachStep::aim(const tracking::Setpoint& setpoint, const profile::AxisSettings& axis,
                   const std::optional<Angle>& place, Angle step, const TravelRange& within)
{
    const double rate = setpoint.rate.degrees();
    const double stopping = rate * rate / (2.0 * axis.limits.acceleration.degrees());
    const double ahead = std::min(std::abs(rate) * kAhead.count(), stopping);
    const Angle wanted = setpoint.position + Angle::fromDegrees(std::copysign(ahead, rate));
    constexpr Angle kFarthest = SwitchedAxis::kFarthest;
    const Angle aim = place ? std::clamp(wanted, *place - kFarthest, *place + kFarthest) : wanted;
    const Angle next = stepInside(aim, step, within);
    const bool turnsBack = m_target && m_way * (next - *m_target) < Angle{};
    const bool isGood = m_target && isInside(within, *m_target) && abs(aim - *m_target) <= kTurnsBack * step;
    if (next == m_target || (turnsBack && isGood)) {
        return false;
    }
    m_way = !m_target ? 0.0 : next < *m_target ? -1.0 : 1.0;
    m_target = next;
    return true;
}

}  // namespace boresight
