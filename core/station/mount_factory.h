// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/moteus_mount/moteus_connection.h"
#include "core/mount/mount_connection.h"
#include "core/profile/profile.h"
#include "core/simple_mount/simple_box.h"
#include "core/station/link_factory.h"
#include "core/station/sensor_factory.h"

#include <memory>

// Makes the mounts of one program, one after the other: the place where every kind of rotator is listed. The simulated
// ones stay the same: after a reconnect they stand where they stood.
namespace boresight {

class MountFactory
{
public:
    // The clock outlives it.
    MountFactory(const profile::Profile& profile, const Clock& clock);

    [[nodiscard]] MountMaker make(const profile::Profile& profile, const MoteusConnection::Start& start) const;
    // Also of the sensor on the simulated mount, while that one is connected.
    [[nodiscard]] SensorMaker sensors(Simulation simulation) const
    {
        return m_links.sensors(simulation != Simulation::Off);
    }

private:
    [[nodiscard]] std::unique_ptr<CanLink> linkTo(const profile::Profile& profile, Simulation simulation) const;

    LinkMaker m_links;
    std::shared_ptr<SimpleBox> m_box = std::make_shared<SimpleBox>();
};

}  // namespace boresight
