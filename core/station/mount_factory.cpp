// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/mount_factory.h"

#include "core/profile/commissioning.h"
#include "core/simple_mount/simple_connection.h"

namespace boresight {

MountFactory::MountFactory(const profile::Profile& profile, const Clock& clock, SimulatedKind simulated)
    : m_links(profile, clock), m_simulated(simulated)
{}

// Behind a bus of a real mount there is never a simulated one.
bool MountFactory::isSimple(const profile::Profile& profile) const
{
    const bool twoMoteus = profile.azimuth.driver == profile::AxisDriver::Moteus &&
                           profile.elevation.driver == profile::AxisDriver::Moteus;
    return profile::isSimulated(profile) && (m_simulated == SimulatedKind::Simple || !twoMoteus);
}

MountMaker MountFactory::make(const profile::Profile& profile, const MoteusConnection::Start& start) const
{
    if (isSimple(profile)) {
        return simpleRotator(m_box, {.azimuth = profile.azimuth.driver != profile::AxisDriver::None,
                                     .elevation = profile.elevation.driver != profile::AxisDriver::None});
    }
    return twoMoteus(m_links.make(profile.bus), start);
}

}  // namespace boresight
