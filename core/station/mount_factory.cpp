// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/mount_factory.h"

#include "core/base/text.h"
#include "core/can/unusable_link.h"
#include "core/mount/paired_connection.h"
#include "core/profile/setting.h"
#include "core/simple_mount/simple_connection.h"

namespace boresight {

namespace {

AxisSet axesWith(const profile::Profile& profile, profile::AxisDriver driver)
{
    return axesIf(profile.azimuth.driver == driver, profile.elevation.driver == driver);
}

// Behind a bus of a real mount there is never a simulated one, whatever the profile says.
AxisSet moteusAxes(const profile::Profile& profile, Simulation simulation)
{
    if (simulation == Simulation::Simple) {
        return {};
    }
    const bool unfit = simulation == Simulation::Off && !profile::fitsRealMount(profile);
    return unfit ? AxisSet(kAxes) : axesWith(profile, profile::AxisDriver::Moteus);
}

SimpleMount::Axes simpleAxes(const profile::Profile& profile, Simulation simulation)
{
    const auto is = [simulation](profile::AxisDriver driver) {
        return driver == profile::AxisDriver::Simple ||
               (simulation == Simulation::Simple && driver == profile::AxisDriver::Moteus);
    };
    return {.azimuth = is(profile.azimuth.driver), .elevation = is(profile.elevation.driver)};
}

}  // namespace

MountFactory::MountFactory(const profile::Profile& profile, const Clock& clock) : m_links(profile, clock) {}

MountMaker MountFactory::make(const profile::Profile& profile, const MoteusConnection::Start& start) const
{
    const SimpleMount::Axes simple = simpleAxes(profile, start.simulation);
    MoteusConnection::Start onBus = start;
    onBus.axes = moteusAxes(profile, start.simulation);
    if (onBus.axes.empty()) {
        return simpleRotator(m_box, simple);
    }
    const MountMaker moteus = moteusRotator(linkTo(profile, start.simulation), onBus);
    if (start.simulation == Simulation::Off || !(simple.azimuth || simple.elevation)) {
        return moteus;
    }
    const MountMaker box = simpleRotator(m_box, simple);
    return simple.azimuth ? pairOf(box, moteus) : pairOf(moteus, box);
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
    return m_links.sensors(simulation != Simulation::Off && moteusAxes(profile, simulation).size() == kAxes.size());
}

}  // namespace boresight
