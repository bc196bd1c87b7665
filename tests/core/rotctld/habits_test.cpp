// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the conclusions from the behaviour of a client: how often it sends, how coarsely it tracks its target, and how
// often it received an error.
#include "core/rotctld/command_rate.h"
#include "core/rotctld/error_cycles.h"
#include "core/rotctld/point_steps.h"

#include <gtest/gtest.h>

namespace boresight::rotctld {
namespace {

using namespace std::chrono_literals;

constexpr SteadyTime kBegin{1h};

// REQ-ROTCTLD-10 (CommandRate.*)
TEST(CommandRate, IsSteadyForASteadyClient)
{
    CommandRate rate(kBegin);
    EXPECT_EQ(rate.perSecond(kBegin), 0.0);
    SteadyTime now = kBegin;
    for (int i = 0; i < 200; ++i) {  // four a second
        rate.count(now);
        if (now - kBegin >= 1s) {
            EXPECT_DOUBLE_EQ(rate.perSecond(now), 4.0) << i;
        }
        now += 250ms;
    }
}

TEST(CommandRate, CountsTheFirstSecondAsItGrows)
{
    CommandRate rate(kBegin);
    rate.count(kBegin + 10ms);
    rate.count(kBegin + 20ms);
    EXPECT_DOUBLE_EQ(rate.perSecond(kBegin + 30ms), 2.0);
}

TEST(CommandRate, ForgetsAfterSixSeconds)
{
    CommandRate rate(kBegin);
    for (int i = 0; i < 10; ++i) {
        rate.count(kBegin + 500ms);
    }
    EXPECT_DOUBLE_EQ(rate.perSecond(kBegin + 5900ms), 2.0);
    EXPECT_DOUBLE_EQ(rate.perSecond(kBegin + 6s), 0.0);
    rate.count(kBegin + 10min);
    EXPECT_DOUBLE_EQ(rate.perSecond(kBegin + 10min + 1s), 0.2);
}

class PointStepsTest : public ::testing::Test
{
protected:
    void point(double azimuth, double elevation, Seconds after)
    {
        now += std::chrono::duration_cast<SteadyTime::duration>(after);
        steps.observe({.azimuth = Angle::fromDegrees(azimuth), .elevation = Angle::fromDegrees(elevation)}, now);
    }

    PointSteps steps;
    SteadyTime now = kBegin;
};

// REQ-ROTCTLD-10 (PointStepsTest.*)
TEST_F(PointStepsTest, LeapsOfAnUnhurriedClientShow)
{
    point(340.0, 10.0, 0s);
    point(349.0, 12.0, 20s);
    point(358.5, 14.0, 20s);
    EXPECT_FALSE(steps.leap());
    point(8.0, 16.0, 20s);  // through north
    ASSERT_TRUE(steps.leap());
    EXPECT_NEAR(steps.leap()->degrees(), 9.0, 1e-9);
    point(8.0, 16.0, 5s);
    EXPECT_TRUE(steps.leap()) << "the same again says nothing";
}

TEST_F(PointStepsTest, AFineStepAfterASilenceClearsIt)
{
    for (int i = 0; i < 6; ++i) {
        point(5.0 * i, 10.0, 10s);
    }
    ASSERT_TRUE(steps.leap());
    point(25.2, 10.0, 4s);
    EXPECT_FALSE(steps.leap());
}

TEST_F(PointStepsTest, CorrectionsOfALeapDoNotHideIt)
{
    for (int i = 0; i < 6; ++i) {
        point(9.5 * i, 10.0, 20s);
        point(9.5 * i + 0.2, 10.0, Seconds(0.8));
        point(9.5 * i + 0.4, 10.0, Seconds(0.8));
    }
    ASSERT_TRUE(steps.leap());
    EXPECT_NEAR(steps.leap()->degrees(), 9.1, 1e-9);
    for (int i = 0; i < 20; ++i) {
        EXPECT_TRUE(steps.leap() || i > 15) << i;
        point(48.0 + 0.4 * i, 10.0, Seconds(0.8));
    }
    EXPECT_FALSE(steps.leap()) << "now it follows closely";
}

TEST_F(PointStepsTest, AFastTargetIsNoLeap)
{
    for (int i = 0; i < 20; ++i) {
        point(8.0 * i, 80.0, 1s);  // 8°/s near the zenith, sent as often as possible
    }
    EXPECT_FALSE(steps.leap());
}

TEST_F(PointStepsTest, AnotherTargetIsNoLeap)
{
    for (int i = 0; i < 6; ++i) {
        point(40.0 * i, 10.0, 20s);
        point(40.0 * i, 20.0, 10min);
    }
    EXPECT_FALSE(steps.leap());
}

class ErrorCyclesTest : public ::testing::Test
{
protected:
    static Result<> error(const char* text) { return failure(ErrorCode::OutOfRange, QString::fromUtf8(text)); }

    const Result<> done = Result<>{};
    ErrorCycles cycles;
};

// REQ-ROTCTLD-1420: A cycle of a client is its targets and the reading of the position after them. The cycles in a row
// with an error are counted as Gpredict counts them: a position that is read does not make up for a refused target.
TEST_F(ErrorCyclesTest, AReadPositionDoesNotMakeUpForARefusedTarget)
{
    for (int i = 1; i <= 3; ++i) {
        cycles.target(error("too low"));
        cycles.reading(done);
        EXPECT_EQ(cycles.inARow(), i);
        EXPECT_EQ(cycles.error().value().text.toStdString(), "too low");
    }
    cycles.target(done);
    cycles.reading(done);
    EXPECT_EQ(cycles.inARow(), 0);
    EXPECT_FALSE(cycles.error());
}

// REQ-ROTCTLD-1420
TEST_F(ErrorCyclesTest, ACycleCountsOnce)
{
    cycles.target(error("too low"));
    cycles.reading(error("no position"));
    EXPECT_EQ(cycles.inARow(), 1);
    EXPECT_EQ(cycles.error().value().text.toStdString(), "too low");
    cycles.reading(error("no position"));
    EXPECT_EQ(cycles.inARow(), 2);
    EXPECT_EQ(cycles.error().value().text.toStdString(), "no position");
}

// REQ-ROTCTLD-1420
TEST_F(ErrorCyclesTest, ACycleWithoutATargetAndWithAPositionEndsTheRow)
{
    cycles.target(error("too low"));
    cycles.reading(done);
    cycles.reading(done);
    EXPECT_EQ(cycles.inARow(), 0);
}

}  // namespace
}  // namespace boresight::rotctld
