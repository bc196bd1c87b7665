// SPDX-License-Identifier: GPL-3.0-or-later
// The mount that parks when nobody needs it.
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

// REQ-CONTROL-960: After park.after_min without a motion and without a command the mount parks, with a line of the log.
// It takes the control from nobody.
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

// REQ-CONTROL-961: Any command of the operator or a client counts, also one that is refused. A client that reads the
// position, and a question of the window, do not.
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

// REQ-CONTROL-962: The last target of a client that only reads the position is no tracking. The mount parks.
TEST_F(IdleParkTest, AClientThatOnlyReadsDoesNotCount)
{
    goUp(kClient);
    for (int i = 0; i < 5 * 60 + 60; ++i) {
        rig.control.positionRead(kClient.clientId);
        rig.run(Seconds(1.0));
    }
    EXPECT_EQ(rig.state(), StationState::Parked);
}

// REQ-CONTROL-963: What is tracked is not idle, although it stands still. Nor is a jog that is held.
TEST_F(IdleParkTest, WhatIsTrackedDoesNotPark)
{
    ASSERT_TRUE(rig.ask(request::Track{targets::parseTarget("radec 12:00:00,+80:00:00", {}).value()}));
    minutes(12.0);
    EXPECT_NE(rig.state(), StationState::Parked);
    EXPECT_TRUE(rig.control.status().tracked);
}

// REQ-CONTROL-964: A mount that nobody has moved since the start, STOP or a fault stays where it is, and so does one at
// its park position. 0 means never.
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
