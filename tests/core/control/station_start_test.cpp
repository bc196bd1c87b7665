// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boresight {
namespace {

using moteus::Mode;
using moteus::Register;

// REQ-AXES-01: Connecting sends queries only. The first command holds the measured position.
TEST(StationControl, ConnectingSendsQueriesOnly)
{
    StationRig rig;
    EXPECT_EQ(rig.state(), StationState::Disconnected);
    rig.run(Seconds(5.0));
    EXPECT_EQ(rig.state(), StationState::Standby);
    EXPECT_EQ(rig.commands(), 0U);
    EXPECT_EQ(rig.control.status().azimuth.state, AxisState::Off);
}

// REQ-AXES-01
TEST(StationControl, TheFirstCommandHoldsTheMeasuredPosition)
{
    StationRig rig;
    rig.azimuth.position = 0.3;
    ASSERT_TRUE(rig.setsOff(110.0, 2.0, Seconds(0.1)));
    ASSERT_GE(rig.azimuth.seen.size(), 2U);
    const auto& first = rig.azimuth.seen.front();
    EXPECT_EQ(first.mode, Mode::Position);
    EXPECT_TRUE(std::isnan(first.fields.at(Register::CommandPosition)));
    EXPECT_EQ(first.fields.at(Register::CommandVelocity), 0.0);
    for (const auto& seen : rig.azimuth.seen) {
        const double position = seen.fields.at(Register::CommandPosition);
        EXPECT_TRUE(std::isnan(position) || std::abs(position - 0.3) < 0.001) << position;
    }
}

// REQ-AXES-02: Every motion frame carries the watchdog time and all limits.
TEST(StationControl, EveryMotionFrameCarriesWatchdogAndLimits)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(30.0, 20.0));
    rig.settle();
    ASSERT_GT(rig.elevation.seen.size(), 50U);
    for (const fakes::IdealDrive* const drive : {&rig.azimuth, &rig.elevation}) {
        for (const auto& seen : drive->seen) {
            EXPECT_NEAR(seen.fields.at(Register::CommandWatchdogTimeout), rig.profile.control.watchdog.count(), 1e-6);
            EXPECT_GT(seen.fields.at(Register::CommandVelocityLimit), 0.0);
            EXPECT_GT(seen.fields.at(Register::CommandAccelerationLimit), 0.0);
            EXPECT_GT(seen.fields.at(Register::CommandMaximumTorque), 0.0);
        }
    }
}

TEST(StationControl, WithoutDrivesRequestsAreAnsweredAtOnce)
{
    StationRig rig;
    rig.azimuth.silent = rig.elevation.silent = true;
    rig.run(Seconds(2.0));
    EXPECT_EQ(rig.state(), StationState::Disconnected);
    const auto answer = rig.point(10.0, 10.0);
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().code, ErrorCode::NoAnswer);
    EXPECT_EQ(rig.control.measured().error().code, ErrorCode::NoAnswer);
    EXPECT_EQ(rig.control.status().alarms.size(), 1U);
}

// REQ-CONTROL-08: A position that is older than 1 s does not count as a position.
TEST(StationControl, APositionOlderThanASecondIsNoPosition)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    EXPECT_TRUE(rig.control.measured());
    rig.elevation.silent = true;
    rig.run(Seconds(0.9));
    EXPECT_TRUE(rig.control.measured());
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.control.measured().error().code, ErrorCode::NoAnswer);
}

TEST(StationControl, ATrustedPowerUpPositionMayBePointed)
{
    profile::Profile profile;
    profile.azimuth.powerUpPosition = profile.elevation.powerUpPosition = profile::PowerUpPosition::Trusted;
    StationRig rig(profile);
    rig.azimuth.home = rig.elevation.home = moteus::HomeState::Rotor;
    rig.run(Seconds(0.2));
    EXPECT_TRUE(rig.point(10.0, 10.0));
}

}  // namespace
}  // namespace boresight
