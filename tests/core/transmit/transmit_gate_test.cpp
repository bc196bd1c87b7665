// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transmit/transmit_gate.h"

#include <gtest/gtest.h>

#include <limits>

namespace boresight::transmit {
namespace {

class TransmitGateTest : public testing::Test
{
protected:
    // The beam is this far below its target, in a part of the sky where this is the whole error.
    Obstacle after(Seconds time, Angle error)
    {
        now += std::chrono::duration_cast<SteadyTime::duration>(time);
        input.beam = SkyPointing{.azimuth = 120_deg, .elevation = 40_deg - error};
        return gate.decide(input, now).obstacle;
    }
    void switchOn()
    {
        (void)after(Seconds(1.0), 0_deg);
        ASSERT_EQ(after(Seconds(0.5), 0_deg), Obstacle::None);
    }

    TransmitGate gate;
    SteadyTime now{std::chrono::hours(1)};
    GateInput input{.target = SkyPointing{.azimuth = 120_deg, .elevation = 40_deg}, .within = 2.5_deg};
};

// REQ-TRANSMIT-02: The output is on only while the beam is nearer to the target than the set part of the beam width,
// measured on the sky. It goes off in the same tick in which the beam is not. It goes on again below nine tenths of
// this limit, after 0.5 s without any obstacle.
TEST_F(TransmitGateTest, IsOffAtTheLimitItselfAtOnce)
{
    switchOn();
    EXPECT_EQ(after(Seconds(0.02), 2.4999_deg), Obstacle::None);
    EXPECT_EQ(after(Seconds(0.02), 2.5001_deg), Obstacle::Away);
    EXPECT_EQ(after(Seconds(0.02), 2.4999_deg), Obstacle::Away) << "not before nine tenths";
    EXPECT_EQ(after(Seconds(10.0), 2.2501_deg), Obstacle::Away);
    EXPECT_EQ(after(Seconds(0.02), 2.2499_deg), Obstacle::Settling);
    EXPECT_EQ(after(Seconds(0.4999), 2.2499_deg), Obstacle::Settling);
    EXPECT_EQ(after(Seconds(0.0002), 2.2499_deg), Obstacle::None);
    EXPECT_EQ(after(Seconds(0.02), 2.4999_deg), Obstacle::None) << "the limit counts again";
}

// An error of exactly the limit is not below it, tested with numbers that need no rounding.
// REQ-TRANSMIT-02
TEST_F(TransmitGateTest, TheLimitItselfIsOutside)
{
    switchOn();
    input.within = 0_deg;
    EXPECT_EQ(after(Seconds(0.02), 0_deg), Obstacle::Away);
}

// REQ-TRANSMIT-02
TEST_F(TransmitGateTest, ADegreeOfAzimuthIsLessHighUp)
{
    input.target = SkyPointing{.azimuth = 350_deg, .elevation = 80_deg};
    input.beam = SkyPointing{.azimuth = 2_deg, .elevation = 80_deg};
    const GateDecision decision = gate.decide(input, now);
    EXPECT_EQ(decision.obstacle, Obstacle::Settling);
    EXPECT_NEAR(decision.error.value().degrees(), 2.08, 0.01);
}

// REQ-TRANSMIT-03: Conditions that change faster than 0.5 s never switch the output on.
TEST_F(TransmitGateTest, NeverChatters)
{
    for (int i = 0; i < 100; ++i) {
        EXPECT_NE(after(Seconds(0.2), 1_deg), Obstacle::None);
        input.obstacle = Obstacle::Fault;
        EXPECT_EQ(after(Seconds(0.02), 1_deg), Obstacle::Fault);
        input.obstacle = Obstacle::None;
    }
    int switched = 0;
    bool on = false;
    for (int i = 0; i < 1000; ++i) {  // 20 s at the limit
        const bool next = after(Seconds(0.02), i % 2 == 0 ? 2.26_deg : 2.24_deg) == Obstacle::None;
        switched += next != on ? 1 : 0;
        on = next;
    }
    EXPECT_EQ(switched, 0);
}

// REQ-TRANSMIT-04: The output is off without a target, without a known position of the beam, and with any other
// obstacle.
TEST_F(TransmitGateTest, UnknownIsOff)
{
    switchOn();
    now += std::chrono::milliseconds(20);
    input.beam.reset();
    EXPECT_EQ(gate.decide(input, now).obstacle, Obstacle::NoPosition);
    switchOn();
    const auto target = std::exchange(input.target, std::nullopt);
    EXPECT_EQ(after(Seconds(0.02), 0_deg), Obstacle::NoTarget);
    input.target = target;
    for (const Obstacle obstacle :
         {Obstacle::Simulated, Obstacle::Stopped, Obstacle::Fault, Obstacle::NotUp, Obstacle::OutOfReach}) {
        switchOn();
        input.obstacle = obstacle;
        EXPECT_EQ(after(Seconds(0.02), 0_deg), obstacle);
        input.obstacle = Obstacle::None;
    }
    switchOn();
    EXPECT_EQ(after(Seconds(0.02), Angle::fromDegrees(std::numeric_limits<double>::quiet_NaN())), Obstacle::Away);
}

}  // namespace
}  // namespace boresight::transmit
