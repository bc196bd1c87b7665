// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/held_target.h"

namespace boresight::rotctld {
namespace {

// Programs that send the axes in two lines send them one after the other.
constexpr Seconds kTogether{10.0};
// A mount that stands a little beside its target would creep with each further one.
constexpr Angle kBeside = Angle::fromDegrees(1.5);

}  // namespace

Result<SkyPointing> HeldTarget::place(const Client& client)
{
    return m_rotator.position(client).map([&](const SkyPointing& now) {
        SkyPointing held = m_rotator.limits().nearest(now);
        if (!m_sent) {
            return held;
        }
        const MotionFlags motion = m_rotator.motion();
        const bool recent = m_clock.now() - m_sent->when < kTogether;
        if (recent || motion.movingLeft || motion.movingRight ||
            abs((m_sent->place.azimuth - now.azimuth).wrapped180()) < kBeside) {
            held.azimuth = m_sent->place.azimuth;
        }
        if (recent || motion.movingUp || motion.movingDown || abs(m_sent->place.elevation - now.elevation) < kBeside) {
            held.elevation = m_sent->place.elevation;
        }
        return held;
    });
}

}  // namespace boresight::rotctld
