// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

using moteus::Mode;

// REQ-CONTROL-14: On closing, the mount decelerates and then the drives are left as the profile says. Drives that were
// never commanded are left untouched.
TEST(StationControl, ClosingDeceleratesThenLeavesTheDrivesAsTheProfileSays)
{
    for (const auto& [how, mode] :
         {std::pair{profile::OnExit::Hold, Mode::Position}, std::pair{profile::OnExit::Brake, Mode::Brake},
          std::pair{profile::OnExit::Off, Mode::Stopped}}) {
        profile::Profile profile;
        profile.control.onExit = how;
        StationRig rig(profile);
        rig.run(Seconds(0.2));
        ASSERT_TRUE(rig.point(100.0, 60.0));
        rig.run(Seconds(2.0));
        rig.control.shutDown();
        EXPECT_FALSE(rig.point(100.0, 60.0));
        for (int i = 0; i < 500 && !rig.control.shutDownDone(); ++i) {
            rig.tick();
        }
        EXPECT_TRUE(rig.control.shutDownDone());
        EXPECT_EQ(rig.azimuth.mode, mode);
        EXPECT_EQ(rig.elevation.mode, mode);
        EXPECT_EQ(rig.azimuth.seen.back().mode, mode);
    }
}

TEST(StationControl, ClosingWaitsForASlowAxis)
{
    profile::Profile profile;
    profile.control.onExit = profile::OnExit::Off;
    profile.azimuth.limits.acceleration = AngularAcceleration::fromDegrees(0.5);
    StationRig rig(profile);
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 400_deg, .elevation = 0_deg}}));
    rig.run(Seconds(25.0));
    rig.control.shutDown();
    AngularRate rate;
    for (int i = 0; i < 2000 && rig.azimuth.mode == Mode::Position; ++i) {
        rate = rig.control.status().azimuth.commandedRate.value_or(AngularRate{});
        rig.tick();
    }
    EXPECT_EQ(rig.azimuth.mode, Mode::Stopped);
    EXPECT_LT(abs(rate).degrees(), 0.1);
}

TEST(StationControl, ClosingWhileADriveIsCapturedLeavesItAsTheProfileSays)
{
    profile::Profile profile;
    profile.control.onExit = profile::OnExit::Brake;
    StationRig rig(profile);
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(100.0, 60.0));
    rig.tick();
    rig.control.shutDown();
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.azimuth.mode, Mode::Brake);
    EXPECT_EQ(rig.elevation.mode, Mode::Brake);
}

// REQ-CONTROL-14
TEST(StationControl, ClosingLeavesDrivesAloneThatWereNeverCommanded)
{
    profile::Profile profile;
    profile.control.onExit = profile::OnExit::Off;
    StationRig rig(profile);
    rig.run(Seconds(0.5));
    rig.control.shutDown();
    rig.run(Seconds(1.0));
    EXPECT_TRUE(rig.control.shutDownDone());
    EXPECT_EQ(rig.commands(), 0U);
}

TEST(StationControl, AClientCannotPushTheRestOutOfTheLog)
{
    StationRig rig({.rotctld = {.control = profile::ControlRule::Last}});
    rig.run(Seconds(0.2));
    const std::uint64_t before = rig.log.lastNumber();
    for (int i = 0; i < 1000; ++i) {
        ASSERT_TRUE(rig.ask(request::Move{{.azimuth = 1_deg_s}}, i % 2 == 0 ? kClient : kOtherClient));
        ASSERT_TRUE(rig.ask(request::Hold{}, kOtherClient));
    }
    EXPECT_LE(rig.log.lastNumber() - before, 5U);
}

// REQ-CONTROL-16: The log has a line for the start of each motion, with its source and reason.
TEST(StationControl, EveryMotionStartNamesSourceAndReason)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(10.0, 20.0));
    auto lines = rig.log.since(0, 1);
    EXPECT_EQ(lines.back().source, kClient.name);
    EXPECT_EQ(lines.back().text, QStringLiteral("moves the mount from 0.00° 0.00°: go to 10.00° 20.00°"));
    ASSERT_TRUE(rig.point(11.0, 20.0));
    EXPECT_EQ(rig.log.since(0, 1).back().number, lines.back().number) << "a stream is one motion";
    ASSERT_TRUE(rig.point(113.0, 10.0, kOperator));
    EXPECT_EQ(rig.log.since(0, 1).back().source, kOperator.name);
}

}  // namespace
}  // namespace boresight
