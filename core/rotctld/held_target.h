// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotctld/rotator.h"

#include <optional>

// The position of an axis that a command of a client does not contain. A real controller has a set-point for each axis,
// and one set-point stays when the other is sent. So the last target of the client is kept while the mount follows it.
// After somebody has moved or stopped the mount, the axis stays where it is measured. Station thread.
namespace boresight::rotctld {

class HeldTarget
{
public:
    // The rotator outlives this.
    explicit HeldTarget(Rotator& rotator) : m_rotator(rotator) {}

    [[nodiscard]] Result<SkyPointing> place(const Client& client);
    // The rotator has accepted this target of the client.
    void sent(const SkyPointing& place) { m_sent = place; }
    // The client has commanded something else.
    void forget() { m_sent.reset(); }

private:
    Rotator& m_rotator;
    std::optional<SkyPointing> m_sent;
};

}  // namespace boresight::rotctld
