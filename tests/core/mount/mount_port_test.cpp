// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/mount/mount_bench.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace boresight {
namespace {

// REQ-MOUNT-07: Two axes with two drivers are one mount. A fault of one driver stops both axes, and neither driver
// turns the axis of the other.
TEST(MountPort, ATroubleOfOneOfTwoDriversStopsBothAxes)
{
    PairBench bench;
    bench.run(Seconds(1.0));
    ASSERT_TRUE(bench.goTo(90.0, 60.0));
    bench.run(Seconds(3.0));
    bench.setElevationLine(false);
    bench.run(Seconds(4.0));
    EXPECT_TRUE(bench.control().faultLatched());
    EXPECT_TRUE(bench.stands(Seconds(3.0)));
    bench.setElevationLine(true);
    bench.run(Seconds(1.0));
    EXPECT_TRUE(bench.stands(Seconds(3.0)));
    ASSERT_TRUE(bench.ask(request::Rearm{}));
    bench.run(Seconds(1.0));
    EXPECT_TRUE(bench.stands(Seconds(3.0)));
    ASSERT_TRUE(bench.goTo(90.0, 60.0));
    bench.run(Seconds(25.0));
    EXPECT_EQ(bench.control().state(), StationState::Hold);
    EXPECT_FALSE(bench.turnedForeignAxes());
}

// REQ-MOUNT-07
TEST(MountPort, ATroubleOfAnotherKindOfDriverStopsBothAxes)
{
    for (const Axis moteus : kAxes) {
        MixedBench bench(moteus);
        bench.run(Seconds(1.0));
        ASSERT_TRUE(bench.goTo(90.0, 60.0));
        bench.run(Seconds(3.0));
        bench.setBoxLine(false);
        bench.run(Seconds(4.0));
        EXPECT_TRUE(bench.control().faultLatched());
        EXPECT_TRUE(bench.stands(Seconds(3.0)));
        bench.setBoxLine(true);
        bench.run(Seconds(2.0));
        EXPECT_TRUE(bench.stands(Seconds(3.0)));
        ASSERT_TRUE(bench.ask(request::Rearm{}));
        bench.run(Seconds(1.0));
        EXPECT_TRUE(bench.stands(Seconds(3.0)));
        ASSERT_TRUE(bench.goTo(90.0, 60.0));
        bench.run(Seconds(25.0));
        EXPECT_EQ(bench.control().state(), StationState::Hold);
        EXPECT_FALSE(bench.turnedForeignAxes());
    }
}

// REQ-MOUNT-07
TEST(MountPort, ATroubleOfTheMoteusStopsTheOtherKindOfDriverToo)
{
    for (const Axis moteus : kAxes) {
        MixedBench bench(moteus);
        bench.run(Seconds(1.0));
        ASSERT_TRUE(bench.goTo(90.0, 60.0));
        bench.run(Seconds(3.0));
        bench.setMoteusLine(false);
        bench.run(Seconds(4.0));
        EXPECT_TRUE(bench.control().faultLatched());
        EXPECT_TRUE(bench.stands(Seconds(3.0)));
        bench.setMoteusLine(true);
        bench.run(Seconds(2.0));
        EXPECT_TRUE(bench.stands(Seconds(3.0)));
    }
}

// REQ-MOUNT-09: A function beyond motion that only one of two drivers has is available for its axis. A function that
// both have is not available.
TEST(MountPort, APairOffersWhatOneOfItsDriversOffers)
{
    MixedBench bench(Axis::Elevation);
    ASSERT_NE(bench.control().mount().service(), nullptr);
    PairBench simple;
    EXPECT_EQ(simple.control().mount().service(), nullptr);
    bench.run(Seconds(1.0));
    const auto refused = bench.ask(request::ChooseTurn{Axis::Azimuth, 10_deg});
    ASSERT_FALSE(refused);
    EXPECT_NE(textOf(refused.error()).find("No moteus turns this axis"), std::string::npos) << textOf(refused.error());
    const DrivesStatus drives = *bench.control().status().drives;
    EXPECT_FALSE(drives.azimuth.present);
    EXPECT_TRUE(drives.elevation.present);
}

// REQ-MOUNT-02: The set-points are never faster than the rotator, whatever the profile permits.
TEST(MountPort, SetPointsAreNoFasterThanTheRotator)
{
    profile::Profile fast;
    fast.azimuth.limits.speed = AngularRate::fromDegrees(20.0);
    fast.elevation.limits.speed = AngularRate::fromDegrees(20.0);
    SimpleBench bench({}, fast);
    bench.run(Seconds(1.0));
    ASSERT_TRUE(bench.goTo(150.0, 80.0));
    for (int i = 0; i < 500; ++i) {
        bench.tick();
        const AxisStatus azimuth = bench.control().status().azimuth;
        ASSERT_LE(azimuth.commandedRate.value_or(AngularRate{}), SimpleBox::kSpeed);
        ASSERT_LT(abs(azimuth.commanded.value_or(bench.truth().azimuth) - bench.truth().azimuth), 2_deg) << i;
    }
}

// Story: a rotator with steps of whole degrees rounded its set-point to the degree beyond a limit of 60.7°.
// REQ-MOUNT-08: A rotator that moves in steps stays inside a travel and inside limits that end between two steps.
TEST(MountPort, ARotatorOfStepsStaysInsideLimitsBetweenTwoSteps)
{
    profile::Profile profile = slowProfile();
    profile.azimuth.geometry.travel = {.min = 5.4_deg, .max = 60.6_deg};
    profile.limits.elevation = {.min = 10.4_deg, .max = 60.7_deg};
    SimpleBench bench({}, profile);
    bench.run(Seconds(1.0));
    EXPECT_FALSE(bench.goTo(30.0, 60.7));
    for (const auto& [rate, end] :
         {std::pair{-5.0, AxisPosition{6_deg, 11_deg}}, std::pair{5.0, AxisPosition{60_deg, 60_deg}}}) {
        const AngularRate both = AngularRate::fromDegrees(rate);
        ASSERT_TRUE(bench.ask(request::Move{{.azimuth = both, .elevation = both}}));
        for (int i = 0; i < 1000; ++i) {
            bench.tick();
            ASSERT_TRUE(profile.azimuth.geometry.travel.contains(bench.truth().azimuth)) << i;
            ASSERT_TRUE(profile.limits.elevation.contains(bench.truth().elevation)) << i;
        }
        bench.expectAt(end, end, Angle::fromDegrees(1e-6));
    }
}

// Story: Park was always refused on a rotator with whole degrees whose limit was the park position, 60.7°.
// REQ-MOUNT-500: A rotator that moves in steps parks at its last step before a limit if the park position is beyond
// that step. A park position outside the limits of the profile is refused.
TEST(MountPort, ARotatorOfStepsParksAtItsLastStepBeforeALimit)
{
    profile::Profile profile = slowProfile();
    profile.limits.elevation = {.min = 10.4_deg, .max = 60.7_deg};
    profile.park = {.azimuth = 30_deg, .elevation = 60.7_deg};
    SimpleBench bench({}, profile);
    bench.run(Seconds(1.0));
    EXPECT_TRUE(bench.control().status().permissions.allows(Action::Park));
    ASSERT_TRUE(bench.ask(request::Park{}));
    bench.run(Seconds(25.0));
    bench.expectAt({30_deg, 60_deg}, {}, Angle::fromDegrees(1e-6));
    EXPECT_EQ(bench.control().state(), StationState::Parked);

    profile.park.elevation = 60.8_deg;
    SimpleBench outside({}, profile);
    outside.run(Seconds(1.0));
    EXPECT_FALSE(outside.control().status().permissions.allows(Action::Park));
    EXPECT_FALSE(outside.ask(request::Park{}));
}

// Story: on a mount with two different rotators "nothing holds the mount" was logged, although the other axis held.
// REQ-MOUNT-501: If the axes belong to different rotators, the log names the drive that was switched off.
TEST(MountPort, SwitchingOffNamesTheDriveOfAPair)
{
    MixedBench pair(Axis::Elevation);
    pair.run(Seconds(1.0));
    ASSERT_TRUE(pair.ask(request::SwitchOff{}));
    EXPECT_EQ(pair.lastLog(), QStringLiteral("switches the elevation drive off, so nothing holds its axis"));
    MoteusBench both;
    both.run(Seconds(1.0));
    ASSERT_TRUE(both.ask(request::SwitchOff{}));
    EXPECT_EQ(both.rig().lastLog(), "switches the drives off, so nothing holds the mount");
}

// Story: a jog was offered at the last step before the end of the travel, and it moved nothing.
TEST(MountPort, AJogBeyondTheLastStepOfTheTravelIsNotOffered)
{
    profile::Profile profile = slowProfile();
    profile.azimuth.geometry.travel = {.min = 5.4_deg, .max = 60.6_deg};
    SimpleBench bench({}, profile);
    bench.run(Seconds(1.0));
    ASSERT_TRUE(bench.goTo(60.0, 30.0));
    bench.run(Seconds(20.0));
    const Permissions may = bench.control().status().permissions;
    EXPECT_EQ(may.reason(Action::JogRight), QStringLiteral("at the upper limit 60.0°"));
    EXPECT_TRUE(may.allows(Action::JogLeft)) << may.reason(Action::JogLeft).toStdString();
    ASSERT_TRUE(bench.ask(request::Move{{.azimuth = AngularRate::fromDegrees(5.0)}}));
    bench.run(Seconds(1.0));
    EXPECT_EQ(bench.control().status().azimuth.state, AxisState::Limit);
}

}  // namespace
}  // namespace boresight
