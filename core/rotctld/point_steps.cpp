// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/point_steps.h"

#include <algorithm>

namespace boresight::rotctld {
namespace {

constexpr Angle kSamePoint = Angle::fromDegrees(0.02);  // the protocol has two decimals
constexpr Angle kFine = Angle::fromDegrees(1.0);
constexpr Angle kLeap = Angle::fromDegrees(2.0);
// A client that tracks closely sends at least this often. Then its steps only show the speed of its target.
constexpr Seconds kSilence{2.5};
// The corrections of one leap end long before this time. A client that still sends then tracks its target closely.
constexpr Seconds kCorrections{15.0};
// A longer pause means another pass or another target.
constexpr Seconds kAnotherTarget{180.0};
constexpr Angle kFarthestLeap = Angle::fromDegrees(25.0);
constexpr int kEnough = 3;

Angle stepBetween(const SkyPointing& one, const SkyPointing& other)
{
    return std::max(abs((one.azimuth - other.azimuth).wrapped180()), abs(one.elevation - other.elevation));
}

}  // namespace

void PointSteps::observe(const SkyPointing& point, SteadyTime now)
{
    const std::optional<SkyPointing> before = m_last;
    const Angle step = before ? stepBetween(point, *before) : Angle();
    if (before && step < kSamePoint) {
        return;  // the same point again
    }
    const Seconds time = now - m_lastTime;
    m_last = point;
    m_lastTime = now;
    if (!before || time > kSilence) {
        m_lastSilence = now;
    }
    if (!before || time > kAnotherTarget || step > kFarthestLeap) {
        return;
    }
    const bool silence = m_lastSilence == now;
    if (silence ? step < kFine : now - m_lastSilence > kCorrections) {
        m_leaps = 0;
    } else if (silence && step > kLeap) {
        m_smallest = m_leaps == 0 ? step : std::min(m_smallest, step);
        ++m_leaps;
    }
}

std::optional<Angle> PointSteps::leap() const
{
    return m_leaps >= kEnough ? std::optional(m_smallest) : std::nullopt;
}

}  // namespace boresight::rotctld
