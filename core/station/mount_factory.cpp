// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/mount_factory.h"

#include "core/base/text.h"
#include "core/can/unusable_link.h"
#include "core/gs232_mount/gs232_rotators.h"
#include "core/moteus_mount/link_factory.h"
#include "core/moteus_mount/moteus_connection.h"
#include "core/mount/paired_connection.h"
#include "core/profile/setting.h"
#include "core/rotctld_mount/hamlib_models.h"
#include "core/rotctld_mount/rotctld_rotators.h"
#include "core/simple_mount/simple_connection.h"

namespace boresight {

using profile::AxisDriver;

MountFactory::MountFactory(const profile::Profile& profile, const Clock& clock) : m_clock(clock)
{
    const LinkMaker links(profile, clock);
    m_simulated = links.simulated();
    // All kinds of rotator. A new kind needs a line here, its offer below, and its name in core/profile/axis_driver.h.
    m_kinds = {
        {AxisDriver::Moteus, moteusRotators(links)},
        {AxisDriver::Gs232, gs232::gs232Rotators()},
        {AxisDriver::Rotctld, rotctl::rotctldRotators()},
        {AxisDriver::Simple, simpleRotators()},
    };
}

std::vector<RotatorOffer> rotatorOffers()
{
    return {moteusOffer(), gs232::gs232Offer(), rotctl::rotctldOffer(), rotctl::hamlibOffer()};
}

RotatorModels rotatorModels()
{
    return rotctl::hamlibModels();
}

MountMaker MountFactory::make(const profile::Profile& profile, const MountStart& start) const
{
    const Result<> fits = start.simulation.on ? Result<>{} : profile::fitsRealMount(profile);
    if (!fits) {
        // The profile does not describe the axes of a real mount, so the bus of a real mount is not opened with it.
        return moteusRotator(std::make_unique<UnusableLink>(toQString(profile.bus), fits.error()),
                             {start.stateDir, start.simulation, start.standingAt});
    }
    const AxisDriver azimuth = driverOf(start.simulation, profile, Axis::Azimuth);
    const AxisDriver elevation = driverOf(start.simulation, profile, Axis::Elevation);
    const auto of = [&](AxisDriver driver) {
        return m_kinds.at(driver)(profile, {start.stateDir, start.simulation, start.standingAt,
                                            axesIf(azimuth == driver, elevation == driver)});
    };
    if (azimuth == elevation || elevation == AxisDriver::None) {
        return of(azimuth);
    }
    return azimuth == AxisDriver::None ? of(elevation) : pairOf(of(azimuth), of(elevation));
}

SensorMaker MountFactory::sensors(const profile::Profile& profile, const Simulation& simulation) const
{
    return sensorMaker(m_clock, hasSensor(simulation, profile) ? m_simulated : nullptr);
}

ShowFault MountFactory::faults(const profile::Profile& profile, const Simulation& simulation) const
{
    if (!simulation.on) {
        return [](std::string_view) { return noFaultOfARealMount(); };
    }
    const AxisSet axes = axesIf(driverOf(simulation, profile, Axis::Azimuth) == AxisDriver::Moteus,
                                driverOf(simulation, profile, Axis::Elevation) == AxisDriver::Moteus);
    return [&clock = m_clock, mount = m_simulated, axes](std::string_view text) {
        return showFault(*mount, clock, axes, text);
    };
}

}  // namespace boresight
