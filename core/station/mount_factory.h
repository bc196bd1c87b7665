// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/inputs/sensor_factory.h"
#include "core/messages/rotator_models.h"
#include "core/messages/rotator_offer.h"
#include "core/mount/mount_kind.h"
#include "core/profile/profile.h"
#include "core/sim_bus/running_faults.h"

#include <map>
#include <memory>
#include <vector>

// Makes the mounts of one program, one after the other. A simulated mount is kept: after a reconnect it stands where it
// stood before.
namespace boresight {

// The rotators that the operator can choose, in the order of the list on the screen.
[[nodiscard]] std::vector<RotatorOffer> rotatorOffers();
// The models of the Hamlib rotator. Runs a program and waits for it: call it on a thread with nothing else to do.
[[nodiscard]] RotatorModels rotatorModels();

class MountFactory
{
public:
    // The clock outlives this.
    MountFactory(const profile::Profile& profile, const Clock& clock);

    // Each axis gets the driver of the profile, or of the simulation. The axes in `start` are ignored.
    [[nodiscard]] MountMaker make(const profile::Profile& profile, const MountStart& start) const;
    // Makes the sensor of the profile. A simulated sensor exists only with the simulated mount that carries it.
    [[nodiscard]] SensorMaker sensors(const profile::Profile& profile, const Simulation& simulation) const;
    // Shows faults on the simulated moteus drives. Refuses for a real mount, and for a mount without such a drive.
    [[nodiscard]] ShowFault faults(const profile::Profile& profile, const Simulation& simulation) const;

private:
    const Clock& m_clock;
    std::map<profile::AxisDriver, MountKind> m_kinds;
    std::shared_ptr<SimulatedMount> m_simulated;  // the two simulated moteus, which also carry the simulated sensor
};

}  // namespace boresight
