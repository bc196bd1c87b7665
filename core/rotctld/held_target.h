// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/rotctld/rotator.h"

#include <optional>

// Where the axes stay that a command of one client does not name. A controller has a set-point for each axis, and one
// of them stays when the other is sent. So does the target here while the mount stands there or goes there. It may have
// been moved since by others: then it stays where it is measured. Station thread.
namespace boresight::rotctld {

class HeldTarget
{
public:
    // Both outlive this.
    HeldTarget(Rotator& rotator, const Clock& clock) : m_rotator(rotator), m_clock(clock) {}

    [[nodiscard]] Result<SkyPointing> place(const Client& client);
    // The rotator has accepted this target of the client.
    void sent(const SkyPointing& place) { m_sent = Sent{.place = place, .when = m_clock.now()}; }
    // The client has commanded something else.
    void forget() { m_sent.reset(); }

private:
    struct Sent
    {
        SkyPointing place;
        SteadyTime when;
    };

    Rotator& m_rotator;
    const Clock& m_clock;
    std::optional<Sent> m_sent;
};

}  // namespace boresight::rotctld
