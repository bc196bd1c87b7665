// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

using moteus::Mode;
using moteus::Register;

// REQ-CONTROL-03: STOP decelerates, holds and latches. It brakes as hard as a drive that has lost its commands, with
// the jerk bounded by the averaging of the profile. The reference mount stops from full speed in 0.3 s. After the reset
// of STOP nothing moves again by itself. Clients that kept sending must first be given control.
TEST(StationControl, StopDeceleratesHoldsAndLatches)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(200.0, 60.0, Seconds(3.0)));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    EXPECT_EQ(rig.state(), StationState::Stopped);
    rig.run(Seconds(3.0));
    const double rest = rig.azimuthDegrees();
    EXPECT_EQ(rig.azimuth.mode, Mode::Position) << "holds, does not go limp";
    EXPECT_EQ(rig.point(10.0, 10.0).error().code, ErrorCode::Refused);
    EXPECT_EQ(rig.point(10.0, 10.0, kOperator).error().code, ErrorCode::Refused);
    EXPECT_EQ(rig.ask(request::Jog{{.azimuth = 1_deg_s}}).error().code, ErrorCode::Refused);
    rig.run(Seconds(3.0));
    EXPECT_EQ(rig.azimuthDegrees(), rest);
}

profile::Profile withoutBrakes()
{
    profile::Profile profile;
    for (profile::AxisSettings* const axis : {&profile.azimuth, &profile.elevation}) {
        axis->limits.acceleration = AngularAcceleration::fromDegrees(0.5);
        axis->limits.jerk = AngularJerk::fromDegrees(5.0);
    }
    return profile;
}

// Story: with 0.5°/s² in the profile, STOP took 14 s and 49°.
// REQ-CONTROL-03
TEST(StationControl, StopBrakesHarderThanAProfileWithoutBrakes)
{
    StationRig rig(withoutBrakes());
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::Move{{.azimuth = 10_deg_s}}));
    rig.run(Seconds(25.0));
    ASSERT_NEAR(rig.control.status().azimuth.commandedRate->degrees(), 10.0, 0.01);
    const double from = rig.azimuthDegrees();
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.azimuth.seen.clear();
    rig.run(Seconds(1.7));
    EXPECT_EQ(rig.control.status().azimuth.commandedRate, AngularRate{});
    EXPECT_LT(rig.azimuthDegrees() - from, 8.0);
    // The drive must be allowed this acceleration: 7.5°/s², in turns.
    double hardest = 0.0;
    for (const auto& [mode, fields] : rig.azimuth.seen) {
        hardest = std::max(hardest, fields.at(Register::CommandAccelerationLimit));
    }
    EXPECT_NEAR(hardest, 7.5 / 360.0, 0.1 / 360.0);
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    rig.azimuth.seen.clear();
    rig.run(Seconds(0.2));
    EXPECT_LE(rig.azimuth.seen.back().fields.at(Register::CommandAccelerationLimit), 0.75 / 360.0);
}

// The reference mount at full speed stops in 0.3 s and 1.4° instead of 1.2 s and 6°, still with bounded jerk.
// REQ-CONTROL-03
TEST(StationControl, StopFromFullSpeedTakesAThirdOfASecond)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(200.0, 10.0, Seconds(4.0)));
    const double from = rig.azimuthDegrees();
    ASSERT_TRUE(rig.ask(request::Stop{}));
    AngularRate before = *rig.control.status().azimuth.commandedRate;
    for (int i = 0; i < 17; ++i) {
        rig.tick();
        const AngularRate now = *rig.control.status().azimuth.commandedRate;
        EXPECT_LE(abs(now - before).degrees(), 50.0 * 0.02 + 1e-6) << i;
        before = now;
    }
    EXPECT_EQ(before, AngularRate{});
    EXPECT_LT(rig.azimuthDegrees() - from, 1.6);
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    ASSERT_TRUE(rig.point(20.0, 10.0, kOperator));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    before = *rig.control.status().azimuth.commandedRate;
    rig.tick();
    EXPECT_LE(abs(*rig.control.status().azimuth.commandedRate - before).degrees(), 10.0 * 0.02 + 1e-6)
        << "Hold is as gentle as before";
}

// REQ-CONTROL-03
TEST(StationControl, AfterResetOfStopNothingComesBackByItself)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(200.0, 60.0, Seconds(1.0)));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(2.0));
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    EXPECT_EQ(rig.state(), StationState::Standby);
    const double rest = rig.azimuthDegrees();
    EXPECT_FALSE(rig.point(200.0, 60.0)) << "a client that goes on sending must not move the mount";
    rig.run(Seconds(2.0));
    EXPECT_EQ(rig.azimuthDegrees(), rest);
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    EXPECT_TRUE(rig.point(200.0, 60.0));
}

// REQ-CONTROL-11: The operator has priority over the clients. Everybody may stop the mount.
TEST(StationControl, TheOperatorGoesBeforeTheClients)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 30.0, Seconds(1.0)));
    ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = -1_deg_s}}));
    EXPECT_EQ(rig.control.status().authority, Authority::Operator);
    EXPECT_EQ(rig.point(100.0, 30.0).error().code, ErrorCode::Refused);
    EXPECT_TRUE(rig.ask(request::Hold{}, kClient)) << "stopping is open to all";
}

TEST(StationControl, HoldFromAClientEndsTheMotionWithoutLatching)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 30.0, Seconds(1.0)));
    ASSERT_TRUE(rig.ask(request::Hold{}, kClient));
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_TRUE(rig.point(20.0, 30.0));
}

// Story: STOP was logged and shown while the mount went on turning by a command that another program had left in the
// drive.
// REQ-CONTROL-04: STOP takes over a drive that moves without a command of Boresight. STOP cannot be reset while the
// mount brakes.
TEST(StationControl, StopTakesOverWhatMovesWithoutOurOrders)
{
    StationRig rig;
    rig.azimuth.mode = Mode::Position;
    rig.run(Seconds(0.7));
    EXPECT_EQ(rig.state(), StationState::Standby);
    ASSERT_FALSE(rig.control.status().alarms.empty());
    EXPECT_EQ(rig.control.status().alarms.front().severity, Severity::Warning);
    EXPECT_EQ(rig.commands(), 0U);
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(0.2));
    ASSERT_FALSE(rig.azimuth.seen.empty());
    EXPECT_TRUE(std::isnan(rig.azimuth.seen.front().fields.at(Register::CommandPosition)));
    EXPECT_TRUE(rig.elevation.seen.empty()) << "a drive that is off stays off";
    EXPECT_EQ(rig.control.status().azimuth.state, AxisState::Stopped);
    EXPECT_EQ(rig.control.status().elevation.state, AxisState::Off);
}

// Story: another tool had set a drive in motion. The drive turned on although STOP was latched, and its silence
// meanwhile was reported as a fault.
TEST(StationControl, StopWhileTheBusIsWithOthersTakesTheDrivesOverWhenItIsBack)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(20.0, 30.0, Seconds(20.0)));
    ASSERT_TRUE(rig.ask(request::ReleaseBus{}));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.control.faultLatched());
    rig.azimuth.seen.clear();
    rig.azimuth.mode = Mode::Position;  // set by the other tool
    ASSERT_TRUE(rig.ask(request::TakeBus{}));
    rig.run(Seconds(0.5));
    ASSERT_FALSE(rig.azimuth.seen.empty());
    EXPECT_TRUE(std::isnan(rig.azimuth.seen.front().fields.at(Register::CommandPosition))) << "hold where you are";
    EXPECT_TRUE(rig.control.status().stopLatched);
    EXPECT_FALSE(rig.control.faultLatched());
}

TEST(StationControl, StopWithoutConnectionTakesADriveOverWhenItAnswers)
{
    StationRig rig;
    rig.azimuth.silent = true;
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(0.5));
    rig.azimuth.mode = Mode::Position;
    rig.azimuth.silent = false;
    rig.run(Seconds(0.5));
    EXPECT_FALSE(rig.azimuth.seen.empty());
    EXPECT_TRUE(rig.elevation.seen.empty());
}

// REQ-CONTROL-04
TEST(StationControl, StopIsNotResetWhileTheMountStillBrakes)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(200.0, 60.0, Seconds(3.0)));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.tick();
    EXPECT_EQ(rig.control.status().azimuth.state, AxisState::Moving);
    EXPECT_EQ(rig.ask(request::ResetStop{}).error().code, ErrorCode::Refused);
    rig.run(Seconds(3.0));
    EXPECT_TRUE(rig.ask(request::ResetStop{}));
}

// Story: the operator pressed Hold, and a second later the next target of the client moved the mount again.
TEST(StationControl, HoldOfTheOperatorIsNotUndoneByAClient)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 30.0, Seconds(1.0)));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    EXPECT_EQ(rig.point(100.0, 30.0).error().code, ErrorCode::Refused);
}

}  // namespace
}  // namespace boresight
