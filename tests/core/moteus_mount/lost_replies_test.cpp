// SPDX-License-Identifier: GPL-3.0-or-later
// The commands to the drives while their replies are missing, before this is a fault.
#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boresight {
namespace {

struct LostReplies : ::testing::Test
{
    LostReplies()
    {
        rig.run(Seconds(0.2));
        EXPECT_TRUE(rig.ask(request::PointAxes{{.azimuth = 180_deg, .elevation = 60_deg}}));
        rig.run(Seconds(3.0));
    }

    [[nodiscard]] double rate() const { return rig.control.status().azimuth.commandedRate->degrees(); }

    StationRig rig;
};

// Story: for a quarter of a second set-points went out at full speed, without replies, to a drive that may have been
// blocked.
// REQ-AXES-24 (LostReplies.*): An axis that does not reply is stopped. After three frames in a row without a reply its
// drive is commanded to brake as hard as by its own watchdog, and the other axis decelerates. Both continue if replies
// return before the silence is a fault and show that the drive was on all the time. One or two lost replies in a row,
// and a late tick of this computer, change nothing.
TEST_F(LostReplies, AnAxisThatNobodySeesIsBroughtToRestByCommand)
{
    const double cruise = rate();
    ASSERT_GT(cruise, 5.0);
    rig.azimuth.mute = true;
    for (int tick = 0; tick < 3; ++tick) {
        rig.tick();
        EXPECT_EQ(rate(), cruise) << "two lost replies in a row are chance";
    }
    const std::size_t commands = rig.azimuth.seen.size();
    const auto elevationRate = [this] { return std::abs(rig.control.status().elevation.commandedRate->degrees()); };
    for (double before = elevationRate(); rig.control.state() != StationState::Disconnected; before = elevationRate()) {
        rig.tick();
        const auto& fields = rig.azimuth.seen.back().fields;
        ASSERT_TRUE(std::isnan(fields.at(moteus::Register::CommandPosition))) << "brake from where you are";
        EXPECT_EQ(fields.at(moteus::Register::CommandVelocity), 0.0);
        EXPECT_NEAR(fields.at(moteus::Register::CommandAccelerationLimit) * 360.0, 125.0, 1e-3)
            << "from 10°/s to rest in 0.08 s";
        EXPECT_LE(elevationRate(), before) << "one axis alone goes nowhere";
    }
    EXPECT_EQ(rig.azimuth.seen.size(), commands + 6) << "commanded on until the silence is certain";
}

// Story: the power of a drive failed for a moment. The commands that were sent without replies enabled it again, and it
// counted as healthy.
TEST_F(LostReplies, ADriveThatComesBackSwitchedOffIsLost)
{
    rig.azimuth.mute = true;
    rig.run(Seconds(0.1));
    rig.azimuth.mute = false;
    rig.azimuth.mode = moteus::Mode::Stopped;
    rig.run(Seconds(0.04));
    EXPECT_TRUE(rig.control.faultLatched());
}

TEST_F(LostReplies, RepliesThatComeBackInTimeLetTheMotionGoOn)
{
    rig.azimuth.mute = true;
    rig.run(Seconds(0.14));
    rig.azimuth.mute = false;
    rig.run(Seconds(1.0));
    EXPECT_GT(rate(), 1.0);
    EXPECT_EQ(rig.state(), StationState::Slew);
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 180.0, 0.001);
    EXPECT_NEAR(rig.elevationDegrees(), 60.0, 0.001);
    EXPECT_FALSE(rig.control.faultLatched());
}

TEST_F(LostReplies, OneOrTwoInARowChangeNoSetPoint)
{
    StationRig undisturbed;
    undisturbed.run(Seconds(0.2));
    ASSERT_TRUE(undisturbed.ask(request::PointAxes{{.azimuth = 180_deg, .elevation = 60_deg}}));
    undisturbed.run(Seconds(3.0));
    for (int tick = 0; tick < 500; ++tick) {
        rig.azimuth.mute = tick % 5 == 0;
        rig.elevation.mute = tick % 7 < 2;
        rig.tick();
        undisturbed.tick();
        ASSERT_EQ(rig.control.status().azimuth.commanded, undisturbed.control.status().azimuth.commanded);
        ASSERT_EQ(rig.control.status().elevation.commanded, undisturbed.control.status().elevation.commanded);
    }
}

TEST_F(LostReplies, ALateTickOfThisComputerIsNone)
{
    const double cruise = rate();
    rig.clock.advance(Seconds(0.1));
    rig.run(Seconds(0.1));
    EXPECT_NEAR(rate(), cruise, 1e-9);
}

}  // namespace
}  // namespace boresight
