// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/first_moves.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace boresight {

namespace {

bool outwards(Angle offset, AngularRate rate)
{
    return (offset > FirstMoves::kFarthest && rate > AngularRate{}) ||
           (offset < -FirstMoves::kFarthest && rate < AngularRate{});
}

}  // namespace

Result<> FirstMoves::admits(const AxisRates& rates, const AxisPosition& place, const AxisPosition& rest)
{
    if (std::max(abs(rates.azimuth), abs(rates.elevation)) > profile::kFastestUnconfirmed) {
        return failure(
            ErrorCode::Refused,
            Text::tr("The directions of the axes are not confirmed. Jog at 5°/s or slower, or confirm them."));
    }
    if (!m_origin) {
        m_origin = place;
    }
    if (outwards(rest.azimuth - m_origin->azimuth, rates.azimuth) ||
        outwards(rest.elevation - m_origin->elevation, rates.elevation)) {
        return failure(ErrorCode::Refused,
                       Text::tr("The directions of the axes are not confirmed. Until then an axis moves at most 2°."));
    }
    return {};
}

bool FirstMoves::exceeded(const AxisRates& rates, const AxisPosition& rest) const
{
    return m_origin && (outwards(rest.azimuth - m_origin->azimuth, rates.azimuth) ||
                        outwards(rest.elevation - m_origin->elevation, rates.elevation));
}

Angle restingPlace(const tracking::Setpoint& now, const tracking::MotionLimits& limits)
{
    // The set-point is a motion averaged over twice this time. So that motion is ahead of the set-point by this time.
    const double lead = limits.acceleration.radians() / limits.jerk.radians();
    const double speed = now.rate.radians() + now.acceleration.radians() * lead;
    const double way = 0.5 * (now.rate.radians() + speed) * lead;
    return now.position + Angle::fromRadians(way + speed * std::abs(speed) / (2.0 * limits.acceleration.radians()));
}

}  // namespace boresight
