// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/mount_factory.h"

#include "core/mqtt/client.h"
#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

// Story: beside the simple rotator the sensor went on showing the two moteus, which nobody moved, and disagreed.
TEST(MountFactory, TheSimulatedSensorIsOnTheTwoMoteusOnly)
{
    fakes::ManualClock clock;
    mqtt::Client broker(clock);
    profile::Profile profile;
    profile.sensor.source = profile::SensorSource::Simulated;
    const MountFactory mounts(profile, clock);
    EXPECT_TRUE(mounts.sensors(profile, Simulation::Reference)(profile, broker));
    EXPECT_FALSE(mounts.sensors(profile, Simulation::Simple)(profile, broker));
    EXPECT_FALSE(mounts.sensors(profile, Simulation::Off)(profile, broker));
    profile.azimuth.driver = profile::AxisDriver::Simple;
    profile.elevation.driver = profile::AxisDriver::None;
    EXPECT_FALSE(mounts.sensors(profile, Simulation::Reference)(profile, broker));
}

}  // namespace
}  // namespace boresight
