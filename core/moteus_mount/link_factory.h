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

// Makes the bus of a name: "socketcan:IFACE", "fdcanusb:PATH" or "simulated". Not opened yet.
namespace boresight {

struct SimulatedMount;

// A simulated mount of its own, as delivered.
[[nodiscard]] Result<std::unique_ptr<CanLink>> makeLink(const std::string& busName, const Clock& clock);

// The simulated mount, each of its drives protected as Fix would leave it for the axis that the profile takes it for,
// whatever turns that axis in reality.
[[nodiscard]] sim::PairSettings protectedPair(const profile::Profile& profile);

// The buses of one program, one after the other. Its simulated mount stays the same one: after a reconnect it stands
// where it stood, and its drives keep what was written into them. It begins with its drives protected for `profile`, as
// a real mount that was fixed before the program ended.
class LinkMaker
{
public:
    // The clock outlives it.
    LinkMaker(const profile::Profile& profile, const Clock& clock);

    // The link that it made before is gone by then. Of a name that means no bus one that says so when it is opened.
    [[nodiscard]] std::unique_ptr<CanLink> make(const std::string& busName) const;
    // To the mount of this profile, or to the simulated one in its place, which has a drive for each axis of `start`.
    [[nodiscard]] std::unique_ptr<CanLink> make(const profile::Profile& profile, const MountStart& start) const;
    [[nodiscard]] const std::shared_ptr<SimulatedMount>& simulated() const { return m_simulated; }

private:
    const Clock& m_clock;
    std::shared_ptr<SimulatedMount> m_simulated;
};

// The moteus at the buses that `links` makes.
[[nodiscard]] MountKind moteusRotators(const LinkMaker& links);
[[nodiscard]] RotatorOffer moteusOffer();

}  // namespace boresight
