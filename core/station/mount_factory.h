// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/rotator_models.h"
#include "core/messages/rotator_offer.h"
#include "core/mount/mount_kind.h"
#include "core/profile/profile.h"
#include "core/station/sensor_factory.h"

#include <map>
#include <memory>
#include <vector>

// Makes the mounts of one program, one after the other. The simulated ones stay the same: after a reconnect they stand
// where they stood.
namespace boresight {

// Those that a person can choose, in the order of the list.
[[nodiscard]] std::vector<RotatorOffer> rotatorOffers();
// Of the offer that has models. Runs a program and waits for it: not on a thread that has anything else to do.
[[nodiscard]] RotatorModels rotatorModels();

class MountFactory
{
public:
    // The clock outlives it.
    MountFactory(const profile::Profile& profile, const Clock& clock);

    // Each axis has the driver of the profile, or of the simulation. Of `start` the axes do not count.
    [[nodiscard]] MountMaker make(const profile::Profile& profile, const MountStart& start) const;
    // Also of the sensor on the simulated mount, while that one is connected.
    [[nodiscard]] SensorMaker sensors(const profile::Profile& profile, const Simulation& simulation) const;

private:
    const Clock& m_clock;
    std::map<profile::AxisDriver, MountKind> m_kinds;
    std::shared_ptr<SimulatedMount> m_sensor;  // the mount that carries the simulated one
};

}  // namespace boresight
