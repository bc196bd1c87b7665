// SPDX-License-Identifier: GPL-3.0-or-later
// The mount parks when nobody uses it.
#include "core/sources/idle_park.h"

#include "core/targets/target_text.h"
#include "tests/core/control/station_rig.h"

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::HasSubstr;

profile::Profile parkingWhenIdle()
{
    profile::Profile profile;
    profile.park = {.azimuth = 20_deg, .elevation = 10_deg};
    profile.parkAfter = 5.0;
    profile.site = {.known = true, .latitude = 38.757_deg, .longitude = -9.117_deg};
    return profile;
}

class IdleParkTest : public testing::Test
{
protected:
    IdleParkTest() { rig.run(Seconds(1.0)); }

    void goUp(const Source& by = kOperator)
    {
        ASSERT_TRUE(rig.point(60.0, 40.0, by));
        rig.settle();
        ASSERT_EQ(rig.state(), StationState::Hold);
    }
    void minutes(double count) { rig.run(Seconds(60.0 * count)); }

    StationRig rig{parkingWhenIdle()};
};

// REQ-CONTROL-960: The mount parks after park.after_min without a motion and without a command, with a line in the log.
// The control authority does not change.
TEST_F(IdleParkTest, ParksAfterItsTime)
{
    goUp();
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    const std::uint64_t motionId = rig.control.motionId();
    minutes(4.9);
    EXPECT_EQ(rig.state(), StationState::Hold);
    minutes(0.3);
    EXPECT_THAT(rig.lastLog(), HasSubstr("after 5 min without a command"));
    minutes(1.0);
    EXPECT_EQ(rig.state(), StationState::Parked);
    EXPECT_NEAR(rig.azimuthDegrees(), 20.0, 0.1);
    EXPECT_EQ(rig.control.authority(), Authority::Clients);
    EXPECT_EQ(rig.control.motionId(), motionId) << "a schedule between two passes goes on";
    EXPECT_TRUE(rig.point(60.0, 40.0, kClient));
}

// REQ-CONTROL-961: Every command of the operator or of a client starts the idle time again, even a refused one. A
// client that reads the position, or a question of the window, does not.
TEST_F(IdleParkTest, ACommandCounts)
{
    goUp();
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    minutes(4.0);
    (void)rig.ask(request::AcknowledgeAlarms{});
    minutes(4.0);
    (void)rig.ask(request::SetReadOnly{.clientId = 99}, kOtherClient);  // refused
    minutes(4.0);
    ASSERT_EQ(rig.state(), StationState::Hold);
    for (int i = 0; i < 60; ++i) {
        rig.control.positionRead(kClient.clientId);
        (void)rig.ask(request::JudgeDirection{});
        minutes(1.0 / 30.0);
    }
    EXPECT_NE(rig.state(), StationState::Hold);
}

// REQ-CONTROL-962: If a client only reads the position, its last target does not count as tracked. The mount parks.
TEST_F(IdleParkTest, AClientThatOnlyReadsDoesNotCount)
{
    goUp(kClient);
    for (int i = 0; i < 5 * 60 + 60; ++i) {
        rig.control.positionRead(kClient.clientId);
        rig.run(Seconds(1.0));
    }
    EXPECT_EQ(rig.state(), StationState::Parked);
}

// REQ-CONTROL-963: While a target is tracked the mount is not idle, even if it stands still. The same holds while a jog
// button is held.
TEST_F(IdleParkTest, WhatIsTrackedDoesNotPark)
{
    ASSERT_TRUE(rig.ask(request::Track{targets::parseTarget("radec 12:00:00,+80:00:00", {}).value()}));
    minutes(12.0);
    EXPECT_NE(rig.state(), StationState::Parked);
    EXPECT_TRUE(rig.control.status().tracked);
}

// REQ-CONTROL-964: A mount that nobody has moved since the start, STOP or a fault stays where it is. So does a mount at
// its park position. 0 switches this function off.
TEST_F(IdleParkTest, NothingStartsByItself)
{
    minutes(6.0);
    EXPECT_EQ(rig.state(), StationState::Standby);
    goUp();
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(5.0));
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    minutes(6.0);
    EXPECT_NEAR(rig.azimuthDegrees(), 60.0, 0.1);
    profile::Profile never = parkingWhenIdle();
    never.parkAfter = 0.0;
    rig.setProfile(never);
    goUp();
    minutes(6.0);
    EXPECT_NEAR(rig.azimuthDegrees(), 60.0, 0.1);
}

// REQ-CONTROL-964
TEST_F(IdleParkTest, ARefusalIsToldOnce)
{
    goUp();
    profile::Profile unconfirmed = parkingWhenIdle();
    unconfirmed.mount.directions = profile::Directions::Unconfirmed;
    rig.setProfile(unconfirmed);
    minutes(5.5);
    EXPECT_THAT(rig.lastLog(), HasSubstr("does not park when idle: "));
    const std::uint64_t lines = rig.log.lastNumber();
    minutes(12.0);
    EXPECT_EQ(rig.log.lastNumber(), lines);
    EXPECT_EQ(rig.state(), StationState::Hold);
}

}  // namespace
}  // namespace boresight
