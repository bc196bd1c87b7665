// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/simulated_station.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

// The operator releases the bus to another tool, which changes a drive, and takes the bus back.
namespace boresight::system_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class ReleasedBus : public ::testing::Test
{
protected:
    ReleasedBus() : client(rig.connect())
    {
        EXPECT_EQ(client->ask("P 60 40\n"), "RPRT 0\n");
        EXPECT_TRUE(rig.settle());
    }

    void otherToolSays(Axis axis, const std::string& command)
    {
        const std::string text = command + '\n';
        rig.link->pair().drive(axis).receiveText(1, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    }

    void otherToolMovesAzimuth()
    {
        otherToolSays(Axis::Azimuth, "d stop");
        rig.run(Seconds(0.1));
        otherToolSays(Axis::Azimuth, "d pos nan 0.02 nan");
        rig.run(Seconds(3.0));
        otherToolSays(Axis::Azimuth, "d stop");
        rig.run(Seconds(3.0));
    }

    SimulatedStation rig;
    std::unique_ptr<fakes::TcpPeer> client;
};

// REQ-CONTROL-21 (ReleasedBus.*)
TEST_F(ReleasedBus, IsRefusedInMotion)
{
    EXPECT_EQ(client->ask("P 200 60\n"), "RPRT 0\n");
    rig.run(Seconds(2.0));
    EXPECT_THAT(rig.ask(request::ReleaseBus{}), HasSubstr("The mount moves"));
    EXPECT_TRUE(rig.settle());
    EXPECT_NEAR(rig.truth(Axis::Azimuth), 200.0, 0.1);
}

TEST_F(ReleasedBus, IsClosedAndTheDrivesHoldByThemselves)
{
    const AxisPosition here = rig.truth();
    ASSERT_EQ(rig.ask(request::ReleaseBus{}), "");
    EXPECT_EQ(rig.link->status().state, LinkState::Closed);
    rig.run(Seconds(5.0));
    EXPECT_EQ(rig.link->status().state, LinkState::Closed) << "it is not opened again behind the other tool's back";
    EXPECT_TRUE(rig.status().drives->released);
    EXPECT_EQ(rig.link->truth(Axis::Elevation).mode, moteus::Mode::PositionTimeout);
    EXPECT_LT(rig.farthestFrom(here), 0.1_deg);
    EXPECT_EQ(client->ask("p\n"), "RPRT -6\n");
    EXPECT_EQ(client->ask("P 10 10\n"), "RPRT -6\n");
    for (const Alarm& alarm : rig.status().alarms) {
        EXPECT_FALSE(alarm.active) << alarm.what.toStdString();
    }
}

TEST_F(ReleasedBus, TakenBackTheDrivesAreReadAnewAndNothingMovesAtFirst)
{
    ASSERT_EQ(rig.ask(request::ReleaseBus{}), "");
    rig.run(Seconds(1.0));
    otherToolSays(Axis::Elevation, "conf set servo.default_timeout_s 0.15");
    const AxisPosition here = rig.truth();
    ASSERT_EQ(rig.ask(request::TakeBus{}), "");
    EXPECT_EQ(rig.link->status().state, LinkState::Up);
    Angle worst;
    for (Seconds passed{0.0}; passed < Seconds(1.0); passed += Seconds(0.1)) {
        EXPECT_THAT(client->ask("P 10 10\n"), StartsWith("RPRT -"));
        EXPECT_NE(rig.ask(request::PointAxes{{.azimuth = 10_deg, .elevation = 10_deg}}), "");
        rig.run(Seconds(0.1));
        worst = std::max(worst, rig.farthestFrom(here));
    }
    EXPECT_LT(worst, 0.05_deg);
    ASSERT_TRUE(rig.runUntil([this] { return rig.ready(); }, Seconds(10.0)))
        << rig.status().drives->armingObstacle.toStdString();
    EXPECT_TRUE(
        rig.logSays(QStringLiteral("changed meanwhile: elevation: servo.default_timeout_s was 0.1 s, is 0.15 s")));
    EXPECT_LT(rig.farthestFrom(here), 0.05_deg) << "reading moves nothing";
    EXPECT_EQ(rig.ask(request::PointAxes{{.azimuth = 10_deg, .elevation = 20_deg}}), "");
    EXPECT_TRUE(rig.settle());
    EXPECT_LT(rig.farthestFrom({.azimuth = 10_deg, .elevation = 20_deg}), 0.1_deg);
}

// tview moves the axis and switches it off. The drive keeps counting, so Boresight knows the position.
TEST_F(ReleasedBus, MovedByTheOtherToolTheMountIsKnownToStandElsewhere)
{
    ASSERT_EQ(rig.ask(request::ReleaseBus{}), "");
    otherToolMovesAzimuth();
    const double there = rig.truth(Axis::Azimuth);
    ASSERT_GT(std::abs(there - 60.0), 10.0);
    ASSERT_EQ(rig.ask(request::TakeBus{}), "");
    ASSERT_TRUE(rig.runUntil([this] { return rig.ready(); }, Seconds(10.0)));
    ASSERT_TRUE(rig.status().azimuth.actual);
    EXPECT_NEAR(rig.status().azimuth.actual->degrees(), there, 0.1);
}

// A tool that moves the axis and then sets the old position value leaves only one trace: the origin of the drive's
// count.
TEST_F(ReleasedBus, MovedAndSetBackByTheOtherToolTheOperatorIsAsked)
{
    const auto reported = rig.link->pair().drive(Axis::Azimuth).reportedPosition();
    ASSERT_EQ(rig.ask(request::ReleaseBus{}), "");
    otherToolMovesAzimuth();
    otherToolSays(Axis::Azimuth, "d exact " + std::to_string(reported));
    ASSERT_EQ(rig.ask(request::TakeBus{}), "");
    ASSERT_TRUE(rig.runUntil([this] { return rig.status().drives->azimuth.turnQuestion.has_value(); }, Seconds(10.0)));
    EXPECT_FALSE(rig.status().azimuth.turnKnown);
    EXPECT_FALSE(rig.status().drives->azimuth.turnQuestion->proposed);
    EXPECT_TRUE(rig.status().elevation.turnKnown) << "nobody has set this one";
    EXPECT_FALSE(rig.status().actual) << "nobody is shown a place";
}

TEST_F(ReleasedBus, WhatTheOtherToolBrokeRefusesMotion)
{
    ASSERT_EQ(rig.ask(request::ReleaseBus{}), "");
    rig.run(Seconds(1.0));
    otherToolSays(Axis::Azimuth, "conf set servo.timeout_mode 12");
    ASSERT_EQ(rig.ask(request::TakeBus{}), "");
    ASSERT_TRUE(rig.runUntil(
        [this] { return rig.status().drives->armingObstacle.contains(QLatin1String("If commands stop is 12")); },
        Seconds(10.0)));
    EXPECT_TRUE(rig.alarmSays(QStringLiteral("If commands stop is 12")));
    const AxisPosition here = rig.truth();
    EXPECT_NE(rig.ask(request::PointAxes{{.azimuth = 10_deg, .elevation = 20_deg}}), "");
    rig.run(Seconds(3.0));
    EXPECT_LT(rig.farthestFrom(here), 0.1_deg);
}

}  // namespace
}  // namespace boresight::system_test
