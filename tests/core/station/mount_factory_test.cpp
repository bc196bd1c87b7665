// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/mount_factory.h"

#include "tests/fakes/manual_clock.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace boresight {
namespace {

// Story: switched to a stored profile of a simple rotator, the program took two moteus on its bus for that one.
// REQ-STATION-49: The bus of a real mount is not opened with a profile that is only fit for a simulation. The alarm
// says why.
TEST(MountFactory, AProfileForASimulationOpensNoBus)
{
    profile::Profile profile;
    profile.bus = "fdcanusb:/dev/does-not-exist";
    profile.azimuth.driver = profile.elevation.driver = profile::AxisDriver::Simple;
    const QTemporaryDir stateDir;
    fakes::ManualClock clock;
    EventLog log(clock);
    AlarmBoard alarms(log, clock);
    const profile::InForce inForce(profile);
    const MountFactory mounts(profile, clock);
    const auto mount = mounts.make(profile, {stateDir.path(), Simulation::Off})(inForce, clock, log, alarms);
    mount->open();
    ASSERT_EQ(alarms.list().size(), 1U);
    const QString what = alarms.list().front().what;
    EXPECT_TRUE(what.contains(QStringLiteral("only simulated"))) << what.toStdString();
}

}  // namespace
}  // namespace boresight
