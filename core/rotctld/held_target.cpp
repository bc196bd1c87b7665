// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/held_target.h"

namespace boresight::rotctld {

Result<SkyPointing> HeldTarget::place(const Client& client)
{
    return m_rotator.position(client).map([&](const SkyPointing& now) {
        return m_sent && m_rotator.follows(client) ? *m_sent : m_rotator.limits().nearest(now);
    });
}

}  // namespace boresight::rotctld
