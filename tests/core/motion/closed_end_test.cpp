// SPDX-License-Identifier: GPL-3.0-or-later
// Ends of the axes that their switches have closed, below every source of motion.
#include "core/motion/motion.h"

#include <gtest/gtest.h>

#include <random>

namespace boresight {
namespace {

constexpr std::chrono::milliseconds kClosedEndTick{20};
constexpr Angle kCloseTo = Angle::fromDegrees(1e-6);

struct ClosedEndTest : testing::Test
{
    ClosedEndTest()
    {
        profile.azimuth.geometry.travel = {-200_deg, 460_deg};
        profile.elevation.geometry.travel = {0_deg, 90_deg};
        motion.emplace(profile);
        motion->start(Axis::Azimuth, 100_deg);
        motion->start(Axis::Elevation, 40_deg);
    }
    void ticks(int count)
    {
        for (int i = 0; i < count; ++i) {
            now += kClosedEndTick;
            motion->advance(now, kClosedEndTick);
            highest = std::max(highest, motion->place().azimuth);
        }
    }
    void jog(double azimuth) { motion->run({.azimuth = AngularRate::fromDegrees(azimuth)}); }
    [[nodiscard]] Angle azimuth() const { return motion->place().azimuth; }

    profile::Profile profile;
    std::optional<Motion> motion;
    SteadyTime now{};
    Angle highest{};
};

// REQ-ENDSWITCH-10: Into an end that its switch has closed no source of motion moves the set-points: they stop at once,
// within the limits of motion, and the way back is open. A set-point that has moved back does not come forward again.
TEST_F(ClosedEndTest, StopsAtOnceAndOnlyTheWayBackIsOpen)
{
    jog(5.0);
    ticks(200);
    ASSERT_TRUE(motion->goesInto(Axis::Azimuth, true));
    ASSERT_FALSE(motion->goesInto(Axis::Azimuth, false));
    const Angle here = azimuth();
    motion->close(Axis::Azimuth, {.upper = true});
    ticks(150);
    const Angle stopped = azimuth();
    EXPECT_TRUE(motion->atRest());
    EXPECT_LT(stopped, here + 4_deg);
    EXPECT_TRUE(motion->goesInto(Axis::Azimuth, true)) << "the jog goes on";
    jog(-5.0);
    ticks(100);
    const Angle back = azimuth();
    EXPECT_LT(back, stopped - 3_deg);
    EXPECT_FALSE(motion->goesInto(Axis::Azimuth, true));
    motion->rest();
    ticks(100);
    const Angle rested = azimuth();
    motion->goTo({.azimuth = 200_deg, .elevation = 60_deg});
    ticks(1000);
    EXPECT_LE(azimuth(), rested + kCloseTo);
    EXPECT_NEAR(motion->place().elevation.degrees(), 60.0, 0.1) << "the other axis is free";
    motion->close(Axis::Azimuth, {});
    ticks(2000);
    EXPECT_NEAR(azimuth().degrees(), 200.0, 0.1);
}

// REQ-ENDSWITCH-10
TEST_F(ClosedEndTest, HoldsForJogsTargetsAndStreamsWhateverTheyAskFor)
{
    std::minstd_rand random(17);
    const auto pick = [&random](double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    };
    for (int run = 0; run < 60; ++run) {
        motion->enforceRegion(run % 5 != 0);
        motion->close(Axis::Azimuth, {});
        motion->goTo({.azimuth = Angle::fromDegrees(pick(0.0, 300.0)), .elevation = Angle::fromDegrees(pick(5, 80))});
        ticks(static_cast<int>(pick(1.0, 400.0)));
        motion->close(Axis::Azimuth, {.upper = true});
        Motion braked = *motion;
        braked.rest();
        for (int i = 0; i < 400; ++i) {
            braked.advance(now + (i + 1) * kClosedEndTick, kClosedEndTick);
        }
        const Angle farthest = std::max(braked.place().azimuth, azimuth());
        highest = azimuth();
        for (int change = 0; change < 8; ++change) {
            const Angle wanted = Angle::fromDegrees(pick(-100.0, 400.0));
            const int kind = static_cast<int>(pick(0.0, 4.0));
            if (kind == 0) {
                jog(pick(-8.0, 8.0));
            } else if (kind == 1) {
                motion->goTo({.azimuth = wanted, .elevation = 30_deg});
            } else if (kind == 2) {
                motion->lead({.azimuth = wanted, .elevation = 50_deg}, {.azimuth = 2_deg_s}, now);
            } else {
                motion->follow({.azimuth = wanted, .elevation = 20_deg}, now);
            }
            ticks(static_cast<int>(pick(1.0, 120.0)));
        }
        ASSERT_LE(highest, farthest + kCloseTo) << "run " << run;
    }
}

// REQ-ENDSWITCH-10
TEST_F(ClosedEndTest, AtBothClosedEndsTheAxisStands)
{
    motion->close(Axis::Azimuth, {.lower = true, .upper = true});
    for (const double rate : {5.0, -5.0}) {
        jog(rate);
        ticks(100);
        EXPECT_NEAR(azimuth().degrees(), 100.0, 1e-6);
    }
}

// REQ-ENDSWITCH-11: From a forbidden place the way out is closed where it leads into a closed end.
TEST_F(ClosedEndTest, HoldsOnTheWayOutOfAKeepOut)
{
    pointing::Region region;
    region.keepOuts = {{"mast", 90_deg, 105_deg, 0_deg, 90_deg}};
    motion->setRegion(region, pointing::PointingModel());
    motion->close(Axis::Azimuth, {.upper = true});
    motion->goTo({.azimuth = 150_deg, .elevation = 40_deg});
    ticks(500);
    EXPECT_NEAR(azimuth().degrees(), 100.0, 1e-6);
    motion->close(Axis::Azimuth, {});
    ticks(1000);
    EXPECT_NEAR(azimuth().degrees(), 150.0, 0.1);
}

}  // namespace
}  // namespace boresight
