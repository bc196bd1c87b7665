// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotctld/rotator.h"

#include <optional>

// Where the axes stay that a command of one client does not name. A controller has a set-point for each axis, and one
// of them stays when the other is sent. So does the target here, while the mount follows it. Once somebody has moved or
// stopped the mount, the axis stays where it is measured. Station thread.
namespace boresight::rotctld {

class HeldTarget
{
public:
    // It outlives this.
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
