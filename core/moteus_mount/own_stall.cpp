// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/own_stall.h"

#include <utility>

namespace boresight {
namespace {

// After a longer stall nobody expects the mount to start moving.
constexpr Seconds kLongest{2.0};
// The drives have this time from the end of the stall to the end of the resumption.
constexpr std::chrono::seconds kOwnStallPatience{1};
constexpr std::chrono::seconds kLongestResumption{10};
// A frame is on its way for some time before it resets the watchdog of the drive.
constexpr double kWatchdogShare = 0.75;
// Braking from 10°/s takes 1.5°.
constexpr Angle kDisplaced = Angle::fromDegrees(2.0);

}  // namespace

bool OwnStall::note(Seconds gap, Seconds watchdog, const AxisPosition& setpoints, SteadyTime now)
{
    if (gap < watchdog * kWatchdogShare) {
        return false;
    }
    const bool slept = m_woke && now - *m_woke < gap;
    const bool alreadyEnded = !m_possible && now - m_end <= kOwnStallPatience;
    m_gap = gap;
    m_end = now;
    m_setpoints = m_resuming ? m_setpoints : setpoints;
    m_possible = gap <= kLongest && !slept && !alreadyEnded;
    return true;
}

bool OwnStall::sent(Seconds watchdog, const AxisPosition& setpoints, SteadyTime now)
{
    const SteadyTime before = std::exchange(m_sent, now).value_or(now);
    const bool seen = now - m_end < watchdog;  // at the beginning of this tick
    return !seen && note(now - before, watchdog, setpoints, now);
}

bool OwnStall::explainsTimeOut(SteadyTime now) const
{
    return m_possible && now - m_end <= kOwnStallPatience;
}

std::optional<Seconds> OwnStall::recent(SteadyTime now) const
{
    return m_gap > Seconds(0.0) && now - m_end <= kOwnStallPatience ? std::optional(m_gap) : std::nullopt;
}

bool OwnStall::isNear(Axis axis, Angle measured) const
{
    return abs(measured - (axis == Axis::Azimuth ? m_setpoints.azimuth : m_setpoints.elevation)) < kDisplaced;
}

bool OwnStall::isLate(SteadyTime now) const
{
    return now - m_end > kOwnStallPatience || now - m_resumingSince > kLongestResumption;
}

void OwnStall::resume(SteadyTime now)
{
    if (!std::exchange(m_resuming, true)) {
        m_resumingSince = now;
    }
}

}  // namespace boresight
