// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that apply at once because their users read the current profile at each use. Other tests show how the rest
// of the station reacts to a change: the region and the Sun (station_sun_test), the drive check (drive_care_test), the
// sensor (sensor_disagreement_test), the calibrations (calibration_follow_test, calibration_points_test), broker and
// server (station_broker_test, station_test).
#include "core/clients/station_rotator.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

using testing::HasSubstr;

bool isAlarmed(const StationRig& rig, const char* words)
{
    return std::ranges::any_of(rig.control.status().alarms, [&](const Alarm& one) {
        return one.active && one.what.contains(QString::fromUtf8(words));
    });
}

double sentTorque(const fakes::IdealDrive& drive)
{
    return drive.seen.back().fields.at(moteus::Register::CommandMaximumTorque);
}

TEST(ProfileInForce, TheDrivesGetTheTorqueOfNow)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(1.0)));
    EXPECT_NEAR(sentTorque(rig.azimuth), rig.profile.azimuth.maxTorque, 1e-3);
    profile::Profile weaker = rig.profile;
    weaker.azimuth.maxTorque = 0.5 * rig.profile.azimuth.maxTorque;
    rig.setProfile(weaker);
    rig.tick();
    EXPECT_NEAR(sentTorque(rig.azimuth), weaker.azimuth.maxTorque, 1e-3);
}

TEST(ProfileInForce, AnAxisIsJudgedByTheNumbersOfNow)
{
    StationRig rig;
    rig.run(Seconds(5.0));
    ASSERT_FALSE(isAlarmed(rig, "drive board"));
    profile::Profile cooler = rig.profile;
    cooler.supervision.boardHot = rig.azimuth.temperature - 1.0;
    rig.setProfile(cooler);
    rig.run(Seconds(5.0));
    EXPECT_TRUE(isAlarmed(rig, "drive board"));
}

TEST(ProfileInForce, ARearmIsRefusedByTheNumbersOfNow)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    rig.azimuth.mode = moteus::Mode::Fault;
    rig.azimuth.fault = 33;
    rig.run(Seconds(0.2));
    ASSERT_EQ(rig.state(), StationState::Fault);
    const profile::Profile before = rig.profile;
    profile::Profile demanding = before;
    demanding.supervision.supplyLow = rig.azimuth.voltage + 6.0;
    demanding.supervision.supplyStop = rig.azimuth.voltage + 4.0;
    rig.setProfile(demanding);
    const Result<> refused = rig.ask(request::Rearm{});
    ASSERT_FALSE(refused);
    EXPECT_THAT(textOf(refused.error()), HasSubstr("It must reach 30.0 V."));
    rig.setProfile(before);
    EXPECT_TRUE(rig.ask(request::Rearm{}));
}

TEST(ProfileInForce, AFaultIsRetriedByTheRuleOfNow)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    profile::Profile retrying = rig.profile;
    retrying.recovery.supply = profile::Retry::Once;
    retrying.recovery.interval = Seconds(10.0);
    rig.setProfile(retrying);
    rig.azimuth.mode = moteus::Mode::Fault;
    rig.azimuth.fault = 40;
    rig.run(Seconds(1.0));
    ASSERT_EQ(rig.state(), StationState::Fault);
    rig.run(Seconds(11.0));
    EXPECT_NE(rig.state(), StationState::Fault);
}

TEST(ProfileInForce, AClientMovesAndReadsByTheSettingsOfNow)
{
    const rotctld::Client client{.id = 1, .address = "127.0.0.1:50000"};
    StationRig rig;
    StationRotator rotator(rig.control, rig.inForce, rig.log, rig.clock);
    rig.run(Seconds(0.2));
    profile::Profile slower = rig.profile;
    slower.jog.fast = 3_deg_s;
    slower.rotctld.azimuth = profile::AzimuthConvention::PlusMinus180;
    rig.setProfile(slower);
    ASSERT_TRUE(rotator.move(client, rotctld::MoveDirection::Left, 100));
    rig.run(Seconds(5.0));
    EXPECT_NEAR(rig.control.status().azimuth.commandedRate->degrees(), -3.0, 1e-6);
    EXPECT_LT(rotator.position(client)->azimuth, 0_deg);
}

}  // namespace
}  // namespace boresight
