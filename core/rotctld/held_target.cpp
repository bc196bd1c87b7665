// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/held_target.h"

namespace boresight::rotctld {

Result<SkyPointing> HeldTarget::place(const Client& client)
{
    return m_rotator.position(client).map([&](const SkyPointing& now) {
        return m_sent && m_rotator.follows(m_sent->client) ? m_sent->place : m_rotator.limits().nearest(now);
    });
}

Result<SkyPointing> HeldTarget::completed(const Client& client, std::optional<Angle> azimuth,
                                          std::optional<Angle> elevation)
{
    const Limits limits = m_rotator.limits();
    if (azimuth && elevation) {
        return SkyPointing{.azimuth = limits.turned(*azimuth), .elevation = *elevation};
    }
    return place(client).map([&](const SkyPointing& held) {
        return SkyPointing{.azimuth = azimuth ? limits.turned(*azimuth) : held.azimuth,
                           .elevation = elevation.value_or(held.elevation)};
    });
}

Result<> HeldTarget::pointTo(const Client& client, const Result<SkyPointing>& place, LineOutcome& outcome)
{
    outcome.motion = true;
    forget();
    return place
        .and_then([&](const SkyPointing& wanted) {
            outcome.point = wanted;
            return m_rotator.pointTo(client, {.azimuth = wanted.azimuth, .elevation = wanted.elevation});
        })
        .map([&](const QString& became) {
            outcome.became = became;
            m_sent = {.client = client, .place = *place};
        });
}

}  // namespace boresight::rotctld
