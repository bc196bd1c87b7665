// SPDX-License-Identifier: GPL-3.0-or-later
// Rotators whose axes stand only at steps of their own: 512 in 180°, 866 in a turn.
#include "core/rotator_box/each_step.h"
#include "tests/core/rotctld_mount/rotctld_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace boresight::rotctl {
namespace {

const Angle kAzimuthStep = Angle::fromTurns(1.0 / 1024.0);
const Angle kElevationStep = Angle::fromTurns(1.0 / 866.0);

double inStepsOf(Angle angle, Angle step)
{
    return angle / step;
}

bool isStep(Angle angle, Angle step)
{
    constexpr double kOfAStep = 1e-6;
    return std::abs(inStepsOf(angle, step) - std::round(inStepsOf(angle, step))) < kOfAStep;
}

// The targets of one axis without a rotator.
class EachStepTest : public testing::Test
{
protected:
    // True if the axis is sent elsewhere.
    bool wants(double degrees, const TravelRange& within = {.min = 0_deg, .max = 360_deg})
    {
        return each.aim({.position = Angle::fromDegrees(degrees)}, {}, std::nullopt, 1_deg, within);
    }
    EachStep each;
};

// REQ-ROTCTLDMOUNT-70: A rotator with steps of its own, such as 512 in 180° or 866 in a turn, is sent only to these. It
// stands at the step that is nearest to the target. Position, target and step are shown as they are.
TEST(SteppedAxis, StandsAtTheNearestStep)
{
    RotctldBench bench(steppedProfile());
    bench.run(Seconds(2.0));
    for (const auto& [azimuth, elevation] :
         {std::pair{100.0, 30.0}, std::pair{100.5, 30.3}, std::pair{99.0, 29.0}, std::pair{350.0, 61.0}}) {
        ASSERT_TRUE(bench.goTo(azimuth, elevation));
        bench.run(Seconds(60.0));
        EXPECT_TRUE(isStep(bench.truth().azimuth, kAzimuthStep)) << azimuth;
        EXPECT_TRUE(isStep(bench.truth().elevation, kElevationStep)) << elevation;
        EXPECT_LE(abs(bench.truth().azimuth - Angle::fromDegrees(azimuth)), 0.5 * kAzimuthStep) << azimuth;
        EXPECT_LE(abs(bench.truth().elevation - Angle::fromDegrees(elevation)), 0.5 * kElevationStep) << elevation;
        EXPECT_TRUE(bench.control().onTarget(0_deg)) << azimuth;
        const StationStatus status = bench.control().status();
        EXPECT_LE(abs(*status.azimuth.target - Angle::fromDegrees(azimuth)), Angle::fromDegrees(1e-6));
        EXPECT_LE(abs(*status.azimuth.actual - bench.truth().azimuth), Angle::fromDegrees(0.01));
        EXPECT_EQ(status.capabilities.axes[0]->step, kAzimuthStep);
        EXPECT_EQ(status.capabilities.axes[1]->step, kElevationStep);
    }
}

// REQ-ROTCTLDMOUNT-71: A target that creeps and jitters across the border between two steps sends the axis once for
// each step, and never to and fro.
TEST(SteppedAxis, DoesNotHuntBetweenTwoSteps)
{
    RotctldBench bench(steppedProfile());
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(100.0, 30.0));
    bench.run(Seconds(40.0));
    const int before = bench.box().moves();
    const Angle start = bench.truth().azimuth;
    int turned = 0;
    Angle last = start;
    constexpr int kSeconds = 240;
    for (int second = 1; second <= kSeconds; ++second) {
        const double jitter = second % 2 == 0 ? 0.03 : -0.03;
        ASSERT_TRUE(bench.goTo(100.0 + 0.005 * second + jitter, 30.0));
        bench.run(Seconds(1.0));
        turned += bench.truth().azimuth < last ? 1 : 0;
        last = bench.truth().azimuth;
    }
    const int sent = bench.box().moves() - before;
    const auto steps = static_cast<int>(std::lround((last - start) / kAzimuthStep));
    std::cout << "| steps | commands |\n| " << steps << " | " << sent << " |\n";
    EXPECT_GE(steps, 3);
    EXPECT_LE(sent, steps);
    EXPECT_EQ(turned, 0);
}

// REQ-ROTCTLDMOUNT-72: A target is not rounded to a step in a keep-out, beyond a limit or beyond the travel, but to the
// nearest step that is permitted.
TEST(SteppedAxis, IsNeverRoundedIntoAKeepOut)
{
    profile::Profile profile = rotctldProfile();
    profile.azimuth.stepsPerTurn = 72.0;
    const pointing::KeepOut mast{
        .name = "mast", .azimuthFrom = 113_deg, .azimuthTo = 127_deg, .elevationMin = 0_deg, .elevationMax = 90_deg};
    profile.limits.keepOuts = {mast};
    profile.limits.azimuth = {.min = 8_deg, .max = 360_deg};
    RotctldBench bench(profile);
    bench.run(Seconds(2.0));
    for (const auto& [target, step] :
         {std::pair{112.9, 110_deg}, std::pair{101.0, 100_deg}, std::pair{8.1, 10_deg}, std::pair{111.0, 110_deg}}) {
        const AxisPosition wanted{.azimuth = Angle::fromDegrees(target), .elevation = 30_deg};
        ASSERT_TRUE(bench.control().request(request::PointAxes{wanted}, kClient));
        for (int look = 0; look < 300; ++look) {
            bench.run(Seconds(0.1));
            ASSERT_FALSE(bench.truth().azimuth > mast.azimuthFrom && bench.truth().azimuth < mast.azimuthTo);
        }
        EXPECT_LE(abs(bench.truth().azimuth - step), Angle::fromDegrees(0.01)) << target;
    }
    EXPECT_FALSE(bench.control().faultLatched());
}

// A whole degree of a GS-232 box is a step like any other.
TEST_F(EachStepTest, TurnsBackOnlyForMoreThanHalfAStep)
{
    each.begin(100_deg, 1_deg);
    EXPECT_FALSE(wants(100.4));
    EXPECT_TRUE(wants(100.6));
    EXPECT_EQ(each.target(), 101_deg);
    EXPECT_FALSE(wants(100.3));
    EXPECT_TRUE(wants(101.6)) << "onwards at the border";
    EXPECT_TRUE(wants(101.2)) << "0.8 of a step";
    EXPECT_EQ(each.target(), 101_deg);
    EXPECT_TRUE(wants(100.4)) << "the same way again";
}

// An edge that moves calls the axis back also by less.
TEST_F(EachStepTest, StaysAtNoStepThatIsNotPermitted)
{
    each.begin(100_deg, 1_deg);
    EXPECT_TRUE(wants(100.6));
    EXPECT_TRUE(wants(100.6, {.min = 0_deg, .max = Angle::fromDegrees(100.7)}));
    EXPECT_EQ(each.target(), 100_deg);
    EXPECT_EQ(stepInside(Angle::fromDegrees(100.6), 1_deg,
                         {.min = Angle::fromDegrees(100.2), .max = Angle::fromDegrees(100.7)}),
              101_deg)
        << "a gap without a step";
}

// REQ-ROTCTLDMOUNT-73: A box that counts coarser than the steps of the profile keeps its own count. A travel without a
// step inside is refused.
TEST(SteppedAxis, NeverHasFinerStepsThanItsBoxCounts)
{
    profile::Profile profile = rotctldProfile();
    profile.azimuth.stepsPerTurn = 36000.0;
    profile.elevation.stepsPerTurn = 36.0;
    profile.elevation.geometry.travel = {.min = 41_deg, .max = 49_deg};
    profile.park.elevation = 45_deg;
    RotctldBench bench(profile);
    bench.run(Seconds(2.0));
    EXPECT_EQ(bench.can().axes[0]->step, Angle::fromDegrees(0.1));
    EXPECT_EQ(bench.can().axes[1]->step, 10_deg);
    EXPECT_FALSE(bench.mount().interlock());
}

}  // namespace
}  // namespace boresight::rotctl
