// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/mount_factory.h"

#include "core/base/text.h"
#include "core/can/unusable_link.h"
#include "core/profile/setting.h"
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
    return moteusRotator(linkTo(profile, start.simulation), start);
}

// The bus of a real mount is not opened with a profile that is not fit for one: what it says of the axes is not so.
std::unique_ptr<CanLink> MountFactory::linkTo(const profile::Profile& profile, Simulation simulation) const
{
    const Result<> fits = simulation == Simulation::Off ? profile::fitsRealMount(profile) : Result<>{};
    if (fits) {
        return m_links.make(profile, simulation);
    }
    return std::make_unique<UnusableLink>(toQString(profile.bus), fits.error());
}

SensorMaker MountFactory::sensors(const profile::Profile& profile, Simulation simulation) const
{
    return m_links.sensors(simulation != Simulation::Off && !isSimple(profile, simulation));
}

}  // namespace boresight
