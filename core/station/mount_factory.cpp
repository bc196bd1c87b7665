// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/mount_factory.h"

#include "core/simple_mount/simple_connection.h"

namespace boresight {

namespace {

// Behind a bus of a real mount there is never a simulated one.
bool isSimple(const profile::Profile& profile, Simulation simulation)
{
    const bool twoMoteus = profile.azimuth.driver == profile::AxisDriver::Moteus &&
                           profile.elevation.driver == profile::AxisDriver::Moteus;
    return simulation == Simulation::Simple || (simulation == Simulation::Reference && !twoMoteus);
}

}  // namespace

MountFactory::MountFactory(const profile::Profile& profile, const Clock& clock) : m_links(profile, clock) {}

MountMaker MountFactory::make(const profile::Profile& profile, const MoteusConnection::Start& start) const
{
    if (isSimple(profile, start.simulation)) {
        return simpleRotator(m_box, {.azimuth = profile.azimuth.driver != profile::AxisDriver::None,
                                     .elevation = profile.elevation.driver != profile::AxisDriver::None});
    }
    return twoMoteus(m_links.make(profile, start.simulation), start);
}

SensorMaker MountFactory::sensors(const profile::Profile& profile, Simulation simulation) const
{
    return m_links.sensors(simulation != Simulation::Off && !isSimple(profile, simulation));
}

}  // namespace boresight
