// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/point_steps.h"

#include <algorithm>

namespace boresight::rotctld {
namespace {

constexpr Angle kSamePoint = Angle::fromDegrees(0.02);  // two decimals on the wire
constexpr Angle kFine = Angle::fromDegrees(1.0);
constexpr Angle kLeap = Angle::fromDegrees(2.0);
// A client that sends whenever it can does so at least this often: what it leaps then is the speed of its target.
constexpr Seconds kSilence{2.5};
// Corrections of one leap are over long before that; who goes on sending so long follows its target closely.
constexpr Seconds kCorrections{15.0};
// Between passes, and where somebody turned to another target.
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
        return;  // said again
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
