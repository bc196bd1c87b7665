// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/drive.h"
#include "tests/fakes/ideal_drive.h"

#include <QByteArray>

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <optional>
#include <utility>

namespace boresight {
namespace {

constexpr RateFollower::Limits kFollowerLimits{
    .speed = MotorRate::fromTurns(0.03), .acceleration = MotorAcceleration::fromTurns(0.045), .tick = Seconds(0.02)};
constexpr MotorTurns kCountOfDrive = MotorTurns::fromTurns(1.0 / 65536.0);

class RateFollowerTest : public testing::Test
{
protected:
    void tick(Seconds step = Seconds(0.02))
    {
        now += std::chrono::duration_cast<SteadyTime::duration>(step);
        follower.begin(now);
    }
    // The drive reports this position and rate.
    void standing(double place, double rate = 0.0)
    {
        tick();
        follower.heard(MotorTurns::fromTurns(place) - 0.5 * kCountOfDrive, MotorRate::fromTurns(rate));
    }
    MotionOrder follow(double place, double rate, double acceleration = 0.0)
    {
        return follower.follow({.position = MotorTurns::fromTurns(place),
                                .rate = MotorRate::fromTurns(rate),
                                .acceleration = MotorAcceleration::fromTurns(acceleration)},
                               kFollowerLimits);
    }

    RateFollower follower;
    SteadyTime now{std::chrono::hours(1)};
};

// REQ-AXES-300: While the set-points move, a drive receives a velocity, and the acceleration that reaches it within one
// tick.
TEST_F(RateFollowerTest, TheVelocityOfTheNextSetPointIsReachedInOneTick)
{
    standing(0.1, 0.01);
    tick();
    const MotionOrder order = follow(0.1002, 0.01, 0.02);
    EXPECT_FALSE(order.place);
    EXPECT_NEAR(order.rate.turns(), 0.0104, 1e-9);
    EXPECT_NEAR(order.acceleration.turns(), 0.02, 1e-6);
}

// REQ-AXES-300
TEST_F(RateFollowerTest, WhatTheDriveIsBehindIsMadeGoodInASecond)
{
    standing(0.1, 0.01);
    tick();
    EXPECT_NEAR(follow(0.1002 + 1e-4, 0.01).rate.turns(), 0.01 + 1e-4, 1e-9);
}

// REQ-AXES-301: For a set-point that stands still, and while the control position of the drive is not known, the drive
// receives a position for its own planner.
TEST_F(RateFollowerTest, ASetPointAtRestIsLeftToThePlanner)
{
    standing(0.1);
    tick();
    const MotionOrder order = follow(0.1, 0.0);
    ASSERT_TRUE(order.place);
    EXPECT_EQ(order.place->turns(), 0.1);
    EXPECT_NEAR(order.acceleration.turns(), 0.0045, 1e-9) << "half a count is not worth a jerk";
}

// REQ-AXES-301
TEST_F(RateFollowerTest, ADriveThatSaysNothingOfItsControlIsLeftToThePlanner)
{
    tick();
    const MotionOrder order = follow(0.1, 0.01);
    ASSERT_TRUE(order.place);
    EXPECT_EQ(order.rate.turns(), 0.01);
    EXPECT_EQ(order.acceleration, kFollowerLimits.acceleration);
}

// REQ-AXES-940: A drive that ignores its own position bounds receives a position and no velocity, because only its
// watchdog would end a velocity.
TEST_F(RateFollowerTest, ADriveWithoutBoundsIsLeftToThePlanner)
{
    standing(0.1, 0.01);
    tick();
    RateFollower::Limits unbounded = kFollowerLimits;
    unbounded.bounded = false;
    const MotionOrder order =
        follower.follow({.position = MotorTurns::fromTurns(0.1002), .rate = MotorRate::fromTurns(0.01)}, unbounded);
    ASSERT_TRUE(order.place);
    EXPECT_EQ(order.rate.turns(), 0.01);
}

// REQ-AXES-301
TEST_F(RateFollowerTest, TwoLostRepliesAreBridgedAndNotAThird)
{
    standing(0.1, 0.01);
    for (const bool bridged : {true, true, true, false}) {
        tick();
        EXPECT_NE(follow(0.1002, 0.01).place.has_value(), bridged);
    }
}

// REQ-AXES-301
TEST_F(RateFollowerTest, FartherOffThanLostFramesExplainIsLeftToThePlanner)
{
    standing(0.1, 0.01);
    tick();
    EXPECT_TRUE(follow(0.101, 0.01).place);
}

// REQ-AXES-302: No commanded velocity exceeds the speed limit of the axis.
TEST_F(RateFollowerTest, NoCorrectionExceedsTheSpeedOfTheAxis)
{
    standing(0.1, 0.03);
    tick();
    EXPECT_EQ(follow(0.1008, 0.03).rate, kFollowerLimits.speed);
    standing(0.1, -0.03);
    tick();
    EXPECT_EQ(follow(0.0992, -0.03).rate, -kFollowerLimits.speed);
}

// Story: a reply that came a tick late was taken for the reply to the next frame, so the drive ran ahead by one tick.
// REQ-AXES-951: The content of a late reply counts for the tick of its frame, and the commands since then are added to
// it. A reply to a frame from before the velocity commands began does not count.
TEST_F(RateFollowerTest, ALateReplyIsComparedWithItsOwnTick)
{
    standing(0.1, 0.01);
    tick();
    tick();
    follower.heard(MotorTurns::fromTurns(0.1005) - 0.5 * kCountOfDrive, MotorRate::fromTurns(0.01), 2);
    EXPECT_NEAR(follow(0.1009 + 1e-4, 0.01).rate.turns(), 0.01 + 1e-4, 1e-9) << "0.1005 two ticks ago";
    follower.leave();
    follower.heard(MotorTurns::fromTurns(0.2), MotorRate{}, 1);
    tick();
    EXPECT_TRUE(follow(0.1, 0.01).place);
}

// A whole drive, with its frames on the wire.
class FollowingDrive : public testing::Test
{
protected:
    FollowingDrive()
    {
        tick();
        drive.engage();
        while (drive.phase() != Drive::Phase::Engaged) {
            tick();
        }
    }
    void tick()
    {
        now += std::chrono::milliseconds(20);
        drive.judge(now);
        if (moving) {
            place += rate * Seconds(0.02);
            drive.setSetpoint({.position = place, .rate = rate});
        }
        frame = drive.frame();
        replies.push_back(ideal.answer(frame, now));
        if (replies.size() > late) {
            if (auto reply = std::exchange(replies.front(), std::nullopt)) {
                reply->received = now;
                drive.take(*reply);
            }
            replies.pop_front();
        }
    }
    [[nodiscard]] double ordered() const { return ideal.seen.back().fields.at(moteus::Register::CommandVelocity); }

    Drive drive{{.id = 1,
                 .maxTorque = 50.0,
                 .speed = MotorRate::fromTurns(0.03),
                 .velocityLimit = MotorRate::fromTurns(0.045),
                 .accelerationLimit = MotorAcceleration::fromTurns(0.045),
                 .emergencyBraking = MotorAcceleration::fromTurns(0.4),
                 .places = {.allowance = MotorTurns::fromTurns(0.001), .speed = MotorRate::fromTurns(0.03)}},
                "azimuth drive"};
    fakes::IdealDrive ideal{1, 0.25};
    SteadyTime now{std::chrono::hours(1)};
    MotorTurns place = MotorTurns::fromTurns(0.25);
    MotorRate rate = MotorRate::fromTurns(0.001);
    bool moving = false;
    CanFrame frame;
    std::deque<std::optional<CanFrame>> replies;
    std::size_t late = 0;  // ticks
};

// REQ-AXES-303: Each velocity command carries the watchdog time, the torque limit and both limits of motion.
TEST_F(FollowingDrive, TheFrameIsAVelocityWithAllItsLimits)
{
    moving = true;
    tick();
    const auto payload = frame.payload();
    const std::string bytes =
        QByteArray(reinterpret_cast<const char*>(payload.data()), static_cast<int>(payload.size()))
            .toHex()
            .toStdString();
    EXPECT_EQ(bytes.substr(0, 10), "01000a0e20") << "mode = position; position, velocity";
    EXPECT_EQ(bytes.substr(10, 8), "0000c07f") << "position: keep the control position (NaN)";
    EXPECT_EQ(bytes.substr(26, 12), "0d2500004842") << "maximum torque 50 Nm";
    EXPECT_EQ(bytes.substr(38, 20), "0f27cdcccc3dec51383d") << "watchdog 0.1 s, velocity limit";
    EXPECT_EQ(bytes.substr(66, 4), "0140") << "the number of the frame";
    EXPECT_EQ(bytes.substr(72, 30), "11001f01160415071e38114014060a") << "the report";
}

// REQ-AXES-940
TEST_F(FollowingDrive, ItsWayBackInsideItsBoundsIsAPlace)
{
    drive.setIgnoreBounds(true);
    moving = true;
    for (int i = 0; i < 5; ++i) {
        tick();
        EXPECT_NEAR(ideal.seen.back().fields.at(moteus::Register::CommandPosition), place.turns(), 1e-6);
    }
    drive.setIgnoreBounds(false);
    tick();
    EXPECT_TRUE(std::isnan(ideal.seen.back().fields.at(moteus::Register::CommandPosition)));
    EXPECT_FALSE(ideal.seen.back().fields.find(moteus::Register::CommandIgnorePositionBounds));
}

// REQ-AXES-304: A tick without a set-point commands the last position and never a velocity. A velocity would run on as
// long as it is repeated.
TEST_F(FollowingDrive, WithoutASetPointNoVelocityIsRepeated)
{
    moving = true;
    for (int i = 0; i < 5; ++i) {
        tick();
    }
    ASSERT_TRUE(std::isnan(ideal.seen.back().fields.at(moteus::Register::CommandPosition)));
    moving = false;
    tick();
    EXPECT_NEAR(ideal.seen.back().fields.at(moteus::Register::CommandPosition), place.turns(), 1e-6);
    EXPECT_EQ(ideal.seen.back().fields.at(moteus::Register::CommandVelocity), 0.0);
}

// Story: late replies made the drive run ahead, here tested on the wire.
// REQ-AXES-950
TEST_F(FollowingDrive, RepliesThatAreTicksLateDoNotMakeItLead)
{
    late = 2;
    moving = true;
    rate = MotorRate::fromTurns(0.005);  // running ahead by one tick would change it by 1e-4
    for (int i = 0; i < 400; ++i) {
        tick();
        if (i > 300) {
            ASSERT_NEAR(ordered(), 0.005, 2e-5) << i;
        }
    }
    EXPECT_NEAR(ideal.position, place.turns(), 0.02 * 0.005 + 2e-5) << "it runs to the set-point within the tick";
}

}  // namespace
}  // namespace boresight
