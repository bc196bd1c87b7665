// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

TEST(StationControl, APointIsReachedAndHeld)
{
    StationRig rig;
    rig.run(Seconds(0.2));
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
    rig.run(Seconds(0.2));
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

// REQ-CONTROL-10: The operator's target outside the limits is refused. A client's target outside the limits goes to the
// nearest allowed point or is refused, as the profile says.
TEST(StationControl, TheOperatorIsRefusedWhatIsOutside)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    const auto answer = rig.point(10.0, -5.0, kOperator);
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().code, ErrorCode::OutOfRange);
    EXPECT_NE(textOf(answer.error()).find("limit"), std::string::npos);
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.commands(), 0U);
    EXPECT_FALSE(rig.ask(request::PointAxes{{.azimuth = 451_deg, .elevation = 0_deg}}));
}

// Story: an operator typed 95 instead of 9.5. The mount turned by 180° to the equal direction at 85°.
TEST(StationControl, TheOperatorIsNotSentOverTheTop)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    const auto answer = rig.point(10.0, 95.0, kOperator);
    ASSERT_FALSE(answer);
    EXPECT_EQ(textOf(answer.error()), "elevation 95.00° above limit 90.00°");
    EXPECT_TRUE(rig.point(10.0, 95.0, kClient)) << "to a client it is a direction";
}

// REQ-CONTROL-10
TEST(StationControl, AClientGetsTheNearestPermittedPoint)
{
    StationRig rig;
    rig.run(Seconds(0.2));
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
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.point(20.0, -5.0).error().code, ErrorCode::OutOfRange);
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.commands(), 0U);
}

TEST(StationControl, ARepeatedTargetDoesNotDisturbTheMotion)
{
    StationRig one;
    StationRig repeated;
    for (StationRig* const rig : {&one, &repeated}) {
        rig->run(Seconds(0.2));
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

// Story: two clients both sent P. Their targets were taken for one path, and the mount ran ahead along it.
TEST(StationControl, AnotherClientBeginsAStreamOfItsOwn)
{
    StationRig rig({.rotctld = {.control = profile::ControlRule::Last}});
    rig.run(Seconds(0.2));
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
    ASSERT_TRUE(rig.setsOff(40.0, 20.0, Seconds(0.5)));
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
    rig.run(Seconds(0.2));
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
    rig.run(Seconds(0.2));
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(rig.ask(request::Step{.azimuth = 1_deg, .elevation = 0.5_deg}));
        rig.run(Seconds(0.2));
    }
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 3.0, 0.001);
    EXPECT_NEAR(rig.elevationDegrees(), 1.5, 0.001);
    EXPECT_FALSE(rig.ask(request::Step{.azimuth = 0_deg, .elevation = -2_deg}));
}

// REQ-CONTROL-13: A jog ends when its keep-alive stops. A client's `M` ends with its connection.
TEST(StationControl, JogEndsWhenTheKeepAliveStops)
{
    StationRig rig;
    rig.run(Seconds(0.2));
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
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::Jog{{.elevation = 2_deg_s}}));
    rig.run(Seconds(0.16));
    ASSERT_TRUE(rig.ask(request::Jog{}));
    EXPECT_EQ(rig.state(), StationState::Hold);
}

TEST(StationControl, JogEndsAtTheEndOfTheTravel)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    for (int i = 0; i < 200; ++i) {
        ASSERT_TRUE(rig.ask(request::Jog{{.elevation = -6_deg_s}}));
        rig.run(Seconds(0.2));
        ASSERT_GE(rig.elevationDegrees(), -1e-6);
    }
    EXPECT_EQ(rig.control.status().elevation.state, AxisState::Limit);
}

// REQ-CONTROL-13
TEST(StationControl, AMoveOfAClientEndsWithTheClient)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::Move{{.azimuth = 3_deg_s}}, kClient));
    rig.run(Seconds(2.0));
    EXPECT_EQ(rig.state(), StationState::Jog);
    rig.control.sourceGone(kOtherClient);
    EXPECT_EQ(rig.state(), StationState::Jog);
    rig.control.sourceGone(kClient);
    EXPECT_EQ(rig.state(), StationState::Hold);
}

}  // namespace
}  // namespace boresight
