// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/motion_memory.h"

#include <gtest/gtest.h>

namespace boresight::supervision {
namespace {

class MotionMemoryTest : public ::testing::Test
{
protected:
    // Continues for `time`, with set-point and axis each at its own rate.
    template <class Memory>
    void go(Memory& memory, Seconds time, AngularRate commanded, AngularRate actual)
    {
        constexpr Seconds kTick{0.02};
        for (Seconds passed{0.0}; passed < time; passed += kTick) {
            seen.now += std::chrono::milliseconds(20);
            seen.received = seen.now;
            seen.commanded += commanded * kTick;
            seen.commandedRate = commanded;
            seen.actual += actual * kTick;
            memory.look(seen);
        }
    }

    AxisObservation seen{.now = SteadyTime(std::chrono::hours(1)), .engaged = true};
};

// Story: an axis stood still for minutes and then needed 0.2 s to break away. It counted as blocked since its last
// motion.
// REQ-SUPERVISION-02 (MotionMemoryTest.*)
TEST_F(MotionMemoryTest, TimeAtRestIsNotTimeUnderCommand)
{
    Progress progress;
    go(progress, Seconds(60.0), {}, {});
    EXPECT_EQ(progress.underCommand(), Seconds(0.0));
    go(progress, Seconds(0.2), 2_deg_s, {});
    EXPECT_TRUE(progress.missing());
    EXPECT_NEAR(progress.underCommand().count(), 0.2, 0.021);
    go(progress, Seconds(0.3), 2_deg_s, 2_deg_s);
    EXPECT_FALSE(progress.missing());
    EXPECT_LT(progress.underCommand().count(), 0.1);
}

TEST_F(MotionMemoryTest, SlowMotionIsJudgedByTheWayAndNotByTheTime)
{
    Progress progress;
    go(progress, Seconds(20.0), 0.01_deg_s, {});
    EXPECT_FALSE(progress.missing()) << "0.2° are too little to tell";
    go(progress, Seconds(12.0), 0.01_deg_s, {});
    EXPECT_TRUE(progress.missing());
    EXPECT_GT(progress.underCommand(), Seconds(30.0));
}

TEST_F(MotionMemoryTest, AQuarterOfTheWayIsMotion)
{
    Progress progress;
    go(progress, Seconds(5.0), 2_deg_s, 0.6_deg_s);
    EXPECT_FALSE(progress.missing());
    go(progress, Seconds(5.0), 2_deg_s, 0.3_deg_s);
    EXPECT_TRUE(progress.missing());
    EXPECT_EQ(progress.against(), Angle{});
}

TEST_F(MotionMemoryTest, MotionAgainstTheCommandIsMeasured)
{
    Progress progress;
    go(progress, Seconds(1.0), -2_deg_s, 0.5_deg_s);
    EXPECT_NEAR(progress.against().degrees(), 0.5, 0.03);
}

// Story: one of ten replies was false. A reply with an error too small to be doubted came just when the axis was about
// to start. It counted as the starting position, and the mount was stopped: "does not move".
// REQ-SUPERVISION-19
TEST_F(MotionMemoryTest, AReplyThatIsFalseByLittleIsNotWhereTheMotionBegan)
{
    Progress progress;
    go(progress, Seconds(10.0), {}, {});
    for (int i = 0; i < 50; ++i) {
        const Angle error = i == 2 ? 0.45_deg : Angle{};
        seen.actual += error;
        go(progress, Seconds(0.02), 0.7_deg_s, 0.7_deg_s);
        seen.actual -= error;
        EXPECT_FALSE(progress.missing()) << i;
        EXPECT_EQ(progress.against(), Angle{}) << i;
    }
}

// REQ-SUPERVISION-19
TEST_F(MotionMemoryTest, AReplyThatIsFalseByLittleDoesNotHideAStall)
{
    Progress progress;
    go(progress, Seconds(10.0), {}, {});
    for (int i = 0; i < 50; ++i) {
        const Angle error = i % 5 == 0 ? 0.45_deg : Angle{};
        seen.actual += error;
        go(progress, Seconds(0.02), 0.7_deg_s, {});
        seen.actual -= error;
    }
    EXPECT_TRUE(progress.missing());
    EXPECT_GT(progress.underCommand(), Seconds(0.9));
}

TEST_F(MotionMemoryTest, AfterAGapNothingIsCompared)
{
    Progress progress;
    go(progress, Seconds(1.0), 2_deg_s, {});
    ASSERT_TRUE(progress.missing());
    seen.now += std::chrono::milliseconds(400);
    progress.look(seen);
    EXPECT_FALSE(progress.missing());
}

// REQ-SUPERVISION-04
TEST_F(MotionMemoryTest, AnAxisThatCoastsHasNotComeToStand)
{
    Standing standing;
    go(standing, Seconds(1.0), 5_deg_s, 5_deg_s);
    EXPECT_FALSE(standing.moved());
    seen.engaged = false;
    go(standing, Seconds(1.0), {}, 3_deg_s);
    EXPECT_FALSE(standing.moved());
    go(standing, Seconds(0.6), {}, {});
    EXPECT_EQ(standing.moved(), Angle{});
    go(standing, Seconds(1.0), {}, 3_deg_s);
    EXPECT_NEAR(standing.moved()->degrees(), 3.0, 0.1);
}

// An elevation axis that sinks slowly by its own weight never stands still, and is still reported.
// REQ-SUPERVISION-04
TEST_F(MotionMemoryTest, AnAxisThatCreepsIsMeasuredFromTheLongestStop)
{
    Standing standing;
    seen.engaged = false;
    go(standing, Seconds(2.9), {}, -0.5_deg_s);
    EXPECT_FALSE(standing.moved());
    go(standing, Seconds(4.1), {}, -0.5_deg_s);
    ASSERT_TRUE(standing.moved());
    EXPECT_NEAR(standing.moved()->degrees(), -2.0, 0.2);
}

TEST_F(MotionMemoryTest, OutwardsIsWhatGoesFartherOut)
{
    Outside outside;
    const TravelRange travel{.min = 0_deg, .max = 90_deg};
    const auto at = [&](double degrees) {
        seen.now += std::chrono::milliseconds(200);
        seen.actual = Angle::fromDegrees(degrees);
        outside.look(seen, travel);
    };
    at(-5.0);
    EXPECT_EQ(outside.beyond(), 5_deg);
    EXPECT_FALSE(outside.outwards()) << "found there";
    at(-5.2);
    EXPECT_TRUE(outside.outwards());
    at(-5.25);
    EXPECT_TRUE(outside.outwards());
    at(-5.0);
    EXPECT_FALSE(outside.outwards());
    at(-4.0);
    at(-4.15);
    EXPECT_TRUE(outside.outwards()) << "out again";
    for (int i = 0; i < 4; ++i) {
        at(-4.15);
    }
    EXPECT_FALSE(outside.outwards()) << "stands";
}

}  // namespace
}  // namespace boresight::supervision
