// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_control.h"

#include "tests/core/station/station_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boresight {
namespace {

using moteus::Mode;
using moteus::Register;

// --- start and connection ---------------------------------------------------------------------------------------

TEST(StationControl, ConnectingSendsQueriesOnly)
{
    StationRig rig;
    EXPECT_EQ(rig.state(), StationState::Disconnected);
    rig.run(Seconds(5.0));
    EXPECT_EQ(rig.state(), StationState::Standby);
    EXPECT_EQ(rig.commands(), 0U);
    EXPECT_EQ(rig.control.status().azimuth.state, AxisState::Off);
}

TEST(StationControl, TheFirstCommandHoldsTheMeasuredPosition)
{
    StationRig rig;
    rig.azimuth.position = 0.3;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(110.0, 2.0));
    rig.run(Seconds(0.1));
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

TEST(StationControl, EveryMotionFrameCarriesWatchdogAndLimits)
{
    StationRig rig;
    rig.run(Seconds(0.1));
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
    EXPECT_EQ(rig.control.status().alarms.size(), 2U);
}

TEST(StationControl, APositionOlderThanASecondIsNoPosition)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    EXPECT_TRUE(rig.control.measured());
    rig.elevation.silent = true;
    rig.run(Seconds(0.9));
    EXPECT_TRUE(rig.control.measured());
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.control.measured().error().code, ErrorCode::NoAnswer);
}

TEST(StationControl, AnUnreferencedDriveMayBeJoggedButNotPointed)
{
    StationRig rig;
    rig.azimuth.home = moteus::HomeState::Rotor;
    rig.run(Seconds(0.1));
    EXPECT_EQ(rig.point(10.0, 10.0).error().code, ErrorCode::Refused);
    EXPECT_EQ(rig.ask(request::Park{}).error().code, ErrorCode::Refused);
    EXPECT_TRUE(rig.ask(request::Jog{{.azimuth = 1_deg_s}}));
}

TEST(StationControl, ATrustedPowerUpPositionMayBePointed)
{
    profile::Profile profile;
    profile.azimuth.powerUpPosition = profile.elevation.powerUpPosition = profile::PowerUpPosition::Trusted;
    StationRig rig(profile);
    rig.azimuth.home = rig.elevation.home = moteus::HomeState::Rotor;
    rig.run(Seconds(0.1));
    EXPECT_TRUE(rig.point(10.0, 10.0));
}

// --- pointing ---------------------------------------------------------------------------------------------------

TEST(StationControl, APointIsReachedAndHeld)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(113.0, 10.0, kOperator));
    rig.tick();
    EXPECT_EQ(rig.state(), StationState::Slew);
    rig.settle();
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_NEAR(rig.azimuthDegrees(), 113.0, 0.001);
    EXPECT_NEAR(rig.elevationDegrees(), 10.0, 0.001);
    EXPECT_NEAR(rig.elevation.position, -100.0 / 360.0, 1e-6);
}

TEST(StationControl, CrossingNorthDoesNotUnwind)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    for (const double azimuth : {300.0, 340.0, 359.0, 2.0, 20.0, 60.0}) {
        ASSERT_TRUE(rig.point(azimuth, 30.0));
        rig.settle();
    }
    EXPECT_NEAR(rig.azimuthDegrees(), 60.0, 0.01) << "from 0° the way to 300° is -60°, and back through north";
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 350_deg, .elevation = 30_deg}}));
    rig.settle();
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    ASSERT_TRUE(rig.point(10.0, 30.0));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 370.0, 0.01);
}

TEST(StationControl, TheOperatorIsRefusedWhatIsOutside)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    const auto answer = rig.point(10.0, -5.0, kOperator);
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().code, ErrorCode::OutOfRange);
    EXPECT_NE(answer.error().text.find("limit"), std::string::npos);
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.commands(), 0U);
    EXPECT_FALSE(rig.ask(request::PointAxes{{.azimuth = 451_deg, .elevation = 0_deg}}));
}

// Story: an operator typed 95, meaning 9.5, and the mount turned by 180° to the equal direction at 85°.
TEST(StationControl, TheOperatorIsNotSentOverTheTop)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    const auto answer = rig.point(10.0, 95.0, kOperator);
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().text, "elevation 95.00° above limit 90.00°");
    EXPECT_TRUE(rig.point(10.0, 95.0, kClient)) << "to a client it is a direction";
}

TEST(StationControl, AClientGetsTheNearestPermittedPoint)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(20.0, -5.0));
    rig.settle();
    const StationStatus status = rig.control.status();
    EXPECT_TRUE(status.limited);
    EXPECT_EQ(status.elevation.state, AxisState::Limit);
    EXPECT_NEAR(rig.elevationDegrees(), 0.0, 0.001);
    EXPECT_NEAR(status.target->elevation.degrees(), -5.0, 1e-9);
    ASSERT_TRUE(rig.point(20.0, 5.0));
    EXPECT_FALSE(rig.control.status().limited);
}

TEST(StationControl, AClientIsRefusedWhereTheProfileSaysSo)
{
    profile::Profile profile;
    profile.rotctld.outsideLimits = profile::OutsideLimits::Refuse;
    StationRig rig(profile);
    rig.run(Seconds(0.1));
    EXPECT_EQ(rig.point(20.0, -5.0).error().code, ErrorCode::OutOfRange);
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.commands(), 0U);
}

TEST(StationControl, ARepeatedTargetDoesNotDisturbTheMotion)
{
    StationRig one;
    StationRig repeated;
    for (StationRig* const rig : {&one, &repeated}) {
        rig->run(Seconds(0.1));
        ASSERT_TRUE(rig->point(80.0, 40.0));
    }
    for (int i = 0; i < 200; ++i) {
        one.tick();
        repeated.tick();
        if (i % 40 == 0) {
            ASSERT_TRUE(repeated.point(80.0, 40.0));
        }
        ASSERT_NEAR(one.azimuthDegrees(), repeated.azimuthDegrees(), 1e-6) << i;
    }
}

// Story: the points of two clients that both sent P made one path, and the mount ran ahead along it.
TEST(StationControl, AnotherClientBeginsAStreamOfItsOwn)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(rig.point(10.0 + 0.5 * i, 30.0));
        rig.run(Seconds(1.0));
    }
    EXPECT_EQ(rig.state(), StationState::Track);
    ASSERT_TRUE(rig.point(20.0, 30.0, kOtherClient));
    rig.tick();
    EXPECT_NEAR(rig.control.status().azimuth.target->degrees(), 20.0, 1e-9);
    EXPECT_NE(rig.state(), StationState::Track);
}

TEST(StationControl, AGoneClientLeavesTheMountGoingToItsLastPoint)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(40.0, 20.0));
    rig.run(Seconds(0.5));
    rig.control.sourceGone(kClient);
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 40.0, 0.001);
    EXPECT_EQ(rig.state(), StationState::Hold);
}

TEST(StationControl, ParkAndHome)
{
    profile::Profile profile;
    profile.park = {.azimuth = 90_deg, .elevation = 45_deg};
    StationRig rig(profile);
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.ask(request::Park{}));
    EXPECT_NE(rig.state(), StationState::Parked);
    rig.settle();
    EXPECT_EQ(rig.state(), StationState::Parked);
    EXPECT_NEAR(rig.azimuthDegrees(), 90.0, 0.001);
    ASSERT_TRUE(rig.ask(request::Home{}));
    rig.settle();
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_NEAR(rig.azimuthDegrees(), 0.0, 0.001);
    EXPECT_NEAR(rig.elevationDegrees(), 0.0, 0.001);
}

TEST(StationControl, StepsAddUpFromTheTarget)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(rig.ask(request::Step{.azimuth = 1_deg, .elevation = 0.5_deg}));
        rig.run(Seconds(0.1));
    }
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 3.0, 0.001);
    EXPECT_NEAR(rig.elevationDegrees(), 1.5, 0.001);
    EXPECT_FALSE(rig.ask(request::Step{.azimuth = 0_deg, .elevation = -2_deg}));
}

// --- jog --------------------------------------------------------------------------------------------------------

TEST(StationControl, JogEndsWhenTheKeepAliveStops)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = 5_deg_s}}));
        rig.run(Seconds(0.06));
    }
    EXPECT_EQ(rig.state(), StationState::Jog);
    EXPECT_GT(rig.azimuthDegrees(), 1.0);
    rig.run(Seconds(0.3));
    EXPECT_EQ(rig.state(), StationState::Hold);
    rig.run(Seconds(2.0));
    const double rest = rig.azimuthDegrees();
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.azimuthDegrees(), rest);
}

TEST(StationControl, ReleasedJogStopsAtOnce)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.ask(request::Jog{{.elevation = 2_deg_s}}));
    rig.run(Seconds(0.16));
    ASSERT_TRUE(rig.ask(request::Jog{}));
    EXPECT_EQ(rig.state(), StationState::Hold);
}

TEST(StationControl, JogEndsAtTheEndOfTheTravel)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    for (int i = 0; i < 200; ++i) {
        ASSERT_TRUE(rig.ask(request::Jog{{.elevation = -6_deg_s}}));
        rig.run(Seconds(0.1));
        ASSERT_GE(rig.elevationDegrees(), -1e-6);
    }
    EXPECT_EQ(rig.control.status().elevation.state, AxisState::Limit);
}

TEST(StationControl, AMoveOfAClientEndsWithTheClient)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.ask(request::Move{{.azimuth = 3_deg_s}}, kClient));
    rig.run(Seconds(2.0));
    EXPECT_EQ(rig.state(), StationState::Jog);
    rig.control.sourceGone(kOtherClient);
    EXPECT_EQ(rig.state(), StationState::Jog);
    rig.control.sourceGone(kClient);
    EXPECT_EQ(rig.state(), StationState::Hold);
}

// --- stop and authority -----------------------------------------------------------------------------------------

TEST(StationControl, StopDeceleratesHoldsAndLatches)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(200.0, 60.0));
    rig.run(Seconds(3.0));
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

TEST(StationControl, AfterResetOfStopNothingComesBackByItself)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(200.0, 60.0));
    rig.run(Seconds(1.0));
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

TEST(StationControl, TheOperatorGoesBeforeTheClients)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(100.0, 30.0));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = -1_deg_s}}));
    EXPECT_EQ(rig.control.status().authority, Authority::Operator);
    EXPECT_EQ(rig.point(100.0, 30.0).error().code, ErrorCode::Refused);
    EXPECT_TRUE(rig.ask(request::Hold{}, kClient)) << "stopping is open to all";
}

TEST(StationControl, HoldFromAClientEndsTheMotionWithoutLatching)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(100.0, 30.0));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::Hold{}, kClient));
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_TRUE(rig.point(20.0, 30.0));
}

// Story: STOP was logged and shown while the mount went on turning by an order that somebody else had left.
TEST(StationControl, StopTakesOverWhatMovesWithoutOurOrders)
{
    StationRig rig;
    rig.azimuth.mode = Mode::Position;
    rig.run(Seconds(0.5));
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

TEST(StationControl, StopIsNotResetWhileTheMountStillBrakes)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(200.0, 60.0));
    rig.run(Seconds(3.0));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.tick();
    EXPECT_EQ(rig.control.status().azimuth.state, AxisState::Moving);
    EXPECT_EQ(rig.ask(request::ResetStop{}).error().code, ErrorCode::Refused);
    rig.run(Seconds(3.0));
    EXPECT_TRUE(rig.ask(request::ResetStop{}));
}

// Story: the Hold button was undone by the next target of the client, a second later.
TEST(StationControl, HoldOfTheOperatorIsNotUndoneByAClient)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(100.0, 30.0));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    EXPECT_EQ(rig.point(100.0, 30.0).error().code, ErrorCode::Refused);
}

// --- faults -----------------------------------------------------------------------------------------------------

TEST(StationControl, AFaultOnOneAxisHoldsTheOtherAndWaitsForRearm)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(100.0, 60.0));
    rig.run(Seconds(2.0));
    rig.azimuth.mode = Mode::Fault;
    rig.azimuth.fault = 38;
    rig.run(Seconds(2.0));
    EXPECT_EQ(rig.state(), StationState::Fault);
    const StationStatus status = rig.control.status();
    ASSERT_FALSE(status.alarms.empty());
    EXPECT_TRUE(status.alarms.front().what.contains(QStringLiteral("38")));
    EXPECT_EQ(status.azimuth.state, AxisState::Fault);
    EXPECT_EQ(rig.elevation.mode, Mode::Position);
    const double rest = rig.elevationDegrees();
    EXPECT_FALSE(rig.point(100.0, 60.0));
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.elevationDegrees(), rest);

    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.state(), StationState::Standby);
    EXPECT_EQ(rig.azimuth.mode, Mode::Stopped);
    EXPECT_EQ(rig.elevation.mode, Mode::Position) << "the healthy axis never goes limp";
    ASSERT_TRUE(rig.point(100.0, 60.0, kOperator));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 100.0, 0.001);
}

TEST(StationControl, ASilentBusInMidMotionNeedsRearm)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(100.0, 60.0));
    rig.run(Seconds(2.0));
    rig.azimuth.silent = rig.elevation.silent = true;
    rig.azimuth.mode = rig.elevation.mode = Mode::PositionTimeout;  // what their watchdogs do
    rig.run(Seconds(0.32));
    EXPECT_EQ(rig.state(), StationState::Disconnected);
    EXPECT_EQ(rig.control.status().alarms.size(), 2U);
    rig.run(Seconds(3.0));
    rig.azimuth.silent = rig.elevation.silent = false;
    rig.run(Seconds(3.0));
    EXPECT_EQ(rig.state(), StationState::Fault);
    const std::size_t before = rig.commands();
    EXPECT_EQ(rig.point(100.0, 60.0).error().code, ErrorCode::Refused);
    rig.run(Seconds(3.0));
    EXPECT_EQ(rig.commands(), before) << "nothing is commanded before re-arming";
    ASSERT_TRUE(rig.ask(request::Rearm{}, kClient));
    rig.run(Seconds(0.3));
    EXPECT_EQ(rig.state(), StationState::Standby);
    // Story: re-armed drives were left in mode 0, and an unbalanced elevation fell to its stop.
    EXPECT_EQ(rig.elevation.mode, Mode::Position) << "what held the axis before holds it again";
    EXPECT_EQ(rig.azimuth.mode, Mode::Position);
    EXPECT_TRUE(rig.point(100.0, 60.0));
}

TEST(StationControl, AFaultAtStartIsShownAndNeedsRearm)
{
    StationRig rig;
    rig.azimuth.mode = Mode::Fault;
    rig.azimuth.fault = 35;
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_TRUE(rig.control.status().alarms.front().what.contains(QStringLiteral("35")));
    EXPECT_FALSE(rig.point(10.0, 10.0));
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.commands(), 0U);
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.state(), StationState::Standby);
    EXPECT_EQ(rig.azimuth.mode, Mode::Stopped);
}

TEST(StationControl, AFaultInStandbyIsShownToo)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    rig.elevation.mode = Mode::Fault;
    rig.elevation.fault = 43;
    rig.elevation.position = std::nan("");  // a drive without an encoder answers, but not where it is
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_TRUE(rig.control.status().alarms.front().what.contains(QStringLiteral("43")));
    EXPECT_FALSE(rig.control.measured());
}

TEST(StationControl, ReArmingIsTheOperatorsWhileTheOperatorHasTakenOver)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(100.0, 60.0));
    rig.run(Seconds(1.0));
    rig.azimuth.mode = Mode::Fault;
    rig.azimuth.fault = 38;
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    EXPECT_EQ(rig.ask(request::Rearm{}, kClient).error().code, ErrorCode::Refused);
    EXPECT_TRUE(rig.ask(request::Rearm{}));
}

// Story: a machine that stopped for 0.3 s blamed the cable, although the replies lay unread in its own buffers.
TEST(StationControl, AStallOfThisComputerIsNotSilenceOfTheDrives)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(100.0, 60.0));
    rig.run(Seconds(1.0));
    rig.clock.advance(Seconds(0.4));
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.state(), StationState::Slew);
    EXPECT_TRUE(rig.control.status().alarms.empty());
    EXPECT_EQ(rig.lastLog(), "this computer stalled for 0.42 s; drives may have stopped by their watchdog");
    rig.azimuth.silent = true;
    rig.run(Seconds(0.3));
    EXPECT_EQ(rig.state(), StationState::Disconnected) << "real silence is noticed as before";
}

TEST(StationControl, AFaultThatComesBackIsShownAgain)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(100.0, 60.0));
    rig.run(Seconds(1.0));
    for (int i = 0; i < 2; ++i) {
        rig.azimuth.mode = Mode::Fault;
        rig.azimuth.fault = 40;
        rig.run(Seconds(0.2));
        EXPECT_EQ(rig.state(), StationState::Fault);
        ASSERT_TRUE(rig.ask(request::Rearm{}));
        rig.run(Seconds(0.2));
        EXPECT_EQ(rig.state(), StationState::Standby);
        ASSERT_TRUE(rig.point(100.0, 60.0, kOperator));
        rig.run(Seconds(0.2));
    }
}

TEST(StationControl, ATimeOutLeftFromAnEarlierProgramIsClearedByTheFirstCommand)
{
    StationRig rig;
    rig.azimuth.mode = rig.elevation.mode = Mode::PositionTimeout;
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.state(), StationState::Standby);
    EXPECT_EQ(rig.control.status().azimuth.state, AxisState::Off) << "it holds by itself: no fault of now";
    EXPECT_EQ(rig.commands(), 0U);
    ASSERT_TRUE(rig.point(10.0, 10.0));
    rig.settle();
    EXPECT_EQ(rig.azimuth.seen.front().mode, Mode::Stopped);
    EXPECT_NEAR(rig.azimuthDegrees(), 10.0, 0.001);
}

TEST(StationControl, ADriveThatIgnoresUsIsAFault)
{
    StationRig rig;
    rig.elevation.deaf = true;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(10.0, 10.0));
    rig.run(Seconds(1.5));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_EQ(rig.azimuthDegrees(), 0.0) << "no axis moves before both hold";
}

TEST(StationControl, ADriveThatWasPowerCycledIsNotCommandedOn)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(100.0, 60.0));
    rig.run(Seconds(1.0));
    rig.azimuth.mode = Mode::Stopped;
    rig.azimuth.home = moteus::HomeState::Rotor;
    rig.azimuth.position = 0.4;
    rig.azimuth.deaf = true;
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.state(), StationState::Fault);
    const std::size_t before = rig.azimuth.seen.size();
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.azimuth.seen.size(), before);
}

TEST(StationControl, AnActiveLimitIsAHintNotAFault)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(100.0, 60.0));
    rig.run(Seconds(1.0));
    rig.azimuth.deaf = true;  // keeps the code below from being cleared
    rig.azimuth.fault = 100;
    rig.tick();
    rig.tick();
    EXPECT_EQ(rig.state(), StationState::Slew);
    ASSERT_FALSE(rig.control.status().alarms.empty());
    EXPECT_EQ(rig.control.status().alarms.front().severity, Severity::Warning);
}

// --- the end ----------------------------------------------------------------------------------------------------

TEST(StationControl, ClosingDeceleratesThenLeavesTheDrivesAsTheProfileSays)
{
    for (const auto& [how, mode] :
         {std::pair{profile::OnExit::Hold, Mode::Position}, std::pair{profile::OnExit::Brake, Mode::Brake},
          std::pair{profile::OnExit::Off, Mode::Stopped}}) {
        profile::Profile profile;
        profile.control.onExit = how;
        StationRig rig(profile);
        rig.run(Seconds(0.1));
        ASSERT_TRUE(rig.point(100.0, 60.0));
        rig.run(Seconds(2.0));
        rig.control.shutDown();
        EXPECT_FALSE(rig.point(100.0, 60.0));
        for (int i = 0; i < 500 && !rig.control.shutDownDone(); ++i) {
            rig.tick();
        }
        EXPECT_TRUE(rig.control.shutDownDone());
        EXPECT_EQ(rig.azimuth.mode, mode);
        EXPECT_EQ(rig.elevation.mode, mode);
        EXPECT_EQ(rig.azimuth.seen.back().mode, mode);
    }
}

TEST(StationControl, ClosingWaitsForASlowAxis)
{
    profile::Profile profile;
    profile.control.onExit = profile::OnExit::Off;
    profile.azimuth.limits.acceleration = AngularAcceleration::fromDegrees(0.5);
    StationRig rig(profile);
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 400_deg, .elevation = 0_deg}}));
    rig.run(Seconds(25.0));
    rig.control.shutDown();
    AngularRate rate;
    for (int i = 0; i < 2000 && rig.azimuth.mode == Mode::Position; ++i) {
        rate = rig.control.status().azimuth.commandedRate.value_or(AngularRate{});
        rig.tick();
    }
    EXPECT_EQ(rig.azimuth.mode, Mode::Stopped);
    EXPECT_LT(abs(rate).degrees(), 0.1);
}

TEST(StationControl, ClosingWhileADriveIsCapturedLeavesItAsTheProfileSays)
{
    profile::Profile profile;
    profile.control.onExit = profile::OnExit::Brake;
    StationRig rig(profile);
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(100.0, 60.0));
    rig.tick();
    rig.control.shutDown();
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.azimuth.mode, Mode::Brake);
    EXPECT_EQ(rig.elevation.mode, Mode::Brake);
}

TEST(StationControl, ClosingLeavesDrivesAloneThatWereNeverCommanded)
{
    profile::Profile profile;
    profile.control.onExit = profile::OnExit::Off;
    StationRig rig(profile);
    rig.run(Seconds(0.5));
    rig.control.shutDown();
    rig.run(Seconds(1.0));
    EXPECT_TRUE(rig.control.shutDownDone());
    EXPECT_EQ(rig.commands(), 0U);
}

// --- the log ----------------------------------------------------------------------------------------------------

TEST(StationControl, AClientCannotPushTheRestOutOfTheLog)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    const std::uint64_t before = rig.log.lastNumber();
    for (int i = 0; i < 1000; ++i) {
        ASSERT_TRUE(rig.ask(request::Move{{.azimuth = 1_deg_s}}, i % 2 == 0 ? kClient : kOtherClient));
        ASSERT_TRUE(rig.ask(request::Hold{}, kOtherClient));
    }
    EXPECT_LE(rig.log.lastNumber() - before, 5U);
}

TEST(StationControl, EveryMotionStartNamesSourceAndReason)
{
    StationRig rig;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.point(10.0, 20.0));
    auto lines = rig.log.since(0, 1);
    EXPECT_EQ(lines.back().source, kClient.name);
    EXPECT_EQ(lines.back().text, QStringLiteral("moves the mount from 0.00° 0.00°: P 10.00° 20.00°"));
    ASSERT_TRUE(rig.point(11.0, 20.0));
    EXPECT_EQ(rig.log.since(0, 1).back().number, lines.back().number) << "a stream is one motion";
    ASSERT_TRUE(rig.point(113.0, 10.0, kOperator));
    EXPECT_EQ(rig.log.since(0, 1).back().source, kOperator.name);
}

}  // namespace
}  // namespace boresight
