// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/orderly_end.h"

#include <algorithm>

namespace boresight {
namespace {

constexpr Seconds kShutDownPatience{5.0};
// The last command is repeated for this long, so that a lost frame does not matter.
constexpr std::chrono::milliseconds kLastOrder{150};

// Before the brake is set, the axes have to be seen to stand still. Its output may answer late.
constexpr Seconds kBrakeLooks{3.0};

// The time to brake from full speed, plus 1 s, and the time of the brake.
Seconds longestStop(const profile::Profile& profile)
{
    const auto stop = [](const tracking::MotionLimits& limits) {
        return Seconds(limits.speed.radians() / limits.acceleration.radians() +
                       2.0 * limits.acceleration.radians() / limits.jerk.radians() + 1.0);
    };
    const Seconds brake = profile.brake.isUsed() ? profile.brake.switching + kBrakeLooks : Seconds(0.0);
    return std::max({kShutDownPatience, stop(profile.azimuth.limits), stop(profile.elevation.limits)}) + brake;
}

}  // namespace

bool OrderlyEnd::begin(const profile::Profile& profile, SteadyTime now)
{
    if (m_phase != Phase::No) {
        return false;
    }
    m_phase = Phase::Slowing;
    m_deadline = now + std::chrono::ceil<std::chrono::milliseconds>(longestStop(profile));
    return true;
}

bool OrderlyEnd::leaves(bool still, SteadyTime now)
{
    if (m_phase == Phase::Slowing && (still || now > m_deadline)) {
        m_phase = Phase::Leaving;
        m_deadline = now + kLastOrder;
        return true;
    }
    if (m_phase == Phase::Leaving && now > m_deadline) {
        m_phase = Phase::Done;
    }
    return false;
}

}  // namespace boresight
