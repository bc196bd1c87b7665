// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/switched_motors.h"

#include "tests/core/gs232_mount/gs232_bench.h"

#include <gtest/gtest.h>

namespace boresight::gs232 {
namespace {

using tracking::Leeway;

// Both axes of a box of whole degrees, which answers four times a second.
class SwitchedMotorsTest : public testing::Test
{
protected:
    void see(const AxisPosition& place, int times = 1)
    {
        for (int i = 0; i < times; ++i) {
            now += std::chrono::milliseconds(250);
            motors.see(Axis::Azimuth, place.azimuth, now);
            motors.see(Axis::Elevation, place.elevation, now);
        }
    }
    void want(const AxisPosition& rest)
    {
        motors.setLeeway(Axis::Azimuth, {.within = {.min = 0_deg, .max = 450_deg}, .rest = rest.azimuth});
        motors.setLeeway(Axis::Elevation, {.within = {.min = 0_deg, .max = 180_deg}, .rest = rest.elevation});
    }
    SwitchedMotors::Targets send()
    {
        const SwitchedMotors::Targets targets = motors.next(now);
        motors.sent(targets, now);
        return targets;
    }

    const profile::InForce profile{gs232Profile()};
    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    SwitchedMotors motors{profile,
                          {.axes = {AxisCapabilities{.step = 1_deg, .rareStarts = true},
                                    AxisCapabilities{.step = 1_deg, .rareStarts = true}}},
                          {1_deg, 1_deg},
                          1_deg};
};

// Story: the resolution of the box was unknown before the first motion. Each box that was connected for longer than two
// seconds then counted as worn, and each stop took two seconds.
TEST_F(SwitchedMotorsTest, ABoxThatWaitsIsNotWorn)
{
    see({100_deg, 20_deg}, 40);
    motors.begin();
    want({105_deg, 20_deg});
    EXPECT_EQ(send()[0], 105_deg);
    see({105_deg, 20_deg});
    EXPECT_FALSE(motors.stand());
    see({105_deg, 20_deg}, 3);
    EXPECT_TRUE(motors.stand());
}

// While one axis coasts, the start of the other one waits. One that runs is stopped earlier or sent back at once.
TEST_F(SwitchedMotorsTest, ARunningAxisIsNotHeldBackByOneThatCoasts)
{
    see({100_deg, 20_deg});
    motors.begin();
    want({112_deg, 22_deg});
    EXPECT_EQ(send()[0], 112_deg);
    see({104_deg, 22_deg});
    want({109_deg, 22_deg});
    EXPECT_EQ(send()[0], 109_deg);
    want({115_deg, 22_deg});
    EXPECT_EQ(send()[0], std::nullopt) << "there is time";
    want({101_deg, 22_deg});
    EXPECT_EQ(send()[0], 101_deg);
}

TEST_F(SwitchedMotorsTest, AStartWaitsForTheOtherAxisThatCoasts)
{
    see({100_deg, 20_deg});
    motors.begin();
    want({100_deg, 22_deg});
    EXPECT_EQ(send()[1], 22_deg);
    see({100_deg, 22_deg});
    want({110_deg, 22_deg});
    EXPECT_EQ(send()[0], std::nullopt);
    see({100_deg, 22_deg}, 4);
    EXPECT_EQ(send()[0], 110_deg);
}

// Story: an axis that did not move was sent to its old target once more, which was not permitted any more.
TEST_F(SwitchedMotorsTest, AnAxisThatDidNotObeyIsSentToItsNewTarget)
{
    see({100_deg, 20_deg});
    motors.begin();
    want({110_deg, 20_deg});
    (void)send();
    want({104_deg, 20_deg});
    const SwitchedMotors::Targets targets = motors.again(Axis::Azimuth);
    EXPECT_EQ(targets[0], 104_deg);
    EXPECT_EQ(targets[1], std::nullopt);
    EXPECT_EQ(motors.command(targets).elevation, 20_deg);
}

TEST_F(SwitchedMotorsTest, AnUnknownAxisGetsNoTarget)
{
    EXPECT_EQ(motors.command({}).azimuth, std::nullopt);
    see({100_deg, 20_deg});
    EXPECT_EQ(motors.command({}).azimuth, 100_deg);
    motors.forget();
    EXPECT_EQ(motors.command({}).azimuth, std::nullopt);
}

}  // namespace
}  // namespace boresight::gs232
