// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/can/can_link.h"
#include "core/messages/rotator_offer.h"
#include "core/mount/mount_kind.h"
#include "core/profile/profile.h"
#include "core/sim/simulated_pair.h"

#include <memory>
#include <string>

// Makes the bus of a name: "socketcan:IFACE", "fdcanusb:PATH" or "simulated". The bus is not opened yet.
namespace boresight {

struct SimulatedMount;

// A link of the name "simulated" has a simulated mount of its own, with commissioned drives.
[[nodiscard]] Result<std::unique_ptr<CanLink>> makeLink(const std::string& busName, const Clock& clock);

// The simulated mount with protected drives: each drive has the safety settings that Fix would write for the axis that
// the profile assigns to its id, even if the drive moves another axis.
[[nodiscard]] sim::PairSettings protectedPair(const profile::Profile& profile);

// Makes the buses of one program, one after the other. All of them lead to the same simulated mount: after a reconnect
// it is where it was, and its drives keep the settings written to them. At the start its drives are protected for
// `profile`, like a real mount after Fix.
class LinkMaker
{
public:
    // The clock outlives it.
    LinkMaker(const profile::Profile& profile, const Clock& clock);

    // The link made before must be gone. For a name that means no bus, returns a link that reports this when it is
    // opened.
    [[nodiscard]] std::unique_ptr<CanLink> make(const std::string& busName) const;
    // The link to the mount of this profile. If `start` asks for the simulation: to the simulated mount, with a drive
    // for each axis of `start`.
    [[nodiscard]] std::unique_ptr<CanLink> make(const profile::Profile& profile, const MountStart& start) const;
    [[nodiscard]] const std::shared_ptr<SimulatedMount>& simulated() const { return m_simulated; }

private:
    const Clock& m_clock;
    std::shared_ptr<SimulatedMount> m_simulated;
};

// The moteus mounts on the buses that `links` makes.
[[nodiscard]] MountKind moteusRotators(const LinkMaker& links);
[[nodiscard]] RotatorOffer moteusOffer();

}  // namespace boresight
