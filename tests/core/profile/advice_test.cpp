// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/advice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

namespace boresight::profile {
namespace {

using ::testing::HasSubstr;

Profile with(double speed, double acceleration, double torque = 50.0)
{
    Profile profile;
    profile.azimuth.limits = {.speed = AngularRate::fromDegrees(speed),
                              .acceleration = AngularAcceleration::fromDegrees(acceleration),
                              .jerk = AngularJerk::fromDegrees(10.0 * acceleration)};
    profile.azimuth.maxTorque = torque;
    return profile;
}

// REQ-PROFILE-04a (Advice.*): A setting that is permitted but probably a mistake gives advice with its numbers, not an
// error. This is a stop from full speed of more than 3 s and 10°, or full speed within 0.1 s. The advice names the
// largest inertia for which the torque is enough.
TEST(Advice, HasNothingOnOrdinaryMounts)
{
    EXPECT_TRUE(adviceOn({}).empty());
    EXPECT_TRUE(adviceOn(with(1.0, 0.2)).empty()) << "a large dish: 5.2 s, but only 2.6°";
    EXPECT_TRUE(adviceOn(with(30.0, 30.0)).empty()) << "a fast one: 18°, but within 1.2 s";
}

// Story: 0.5°/s² passed the check. The mount took 14 s and 49° to stop from 7°/s.
TEST(Advice, TellsOfBrakesThatAreNone)
{
    const auto advice = adviceOn(with(7.0, 0.5));
    ASSERT_EQ(advice.size(), 1U);
    EXPECT_EQ(advice.front().key, "azimuth.max_acceleration_deg_s2");
    EXPECT_THAT(advice.front().what.toStdString(), HasSubstr("needs 14.2 s and 50° to stop from 7.0°/s"));
    EXPECT_THAT(advice.front().remedy.toStdString(), HasSubstr("Raise max_acceleration_deg_s2 (0.5)"));
}

// Story: 300°/s² with 50 Nm passed the check, and every reversal ended in a fault.
TEST(Advice, TellsOfAnAccelerationThatNoTorqueGives)
{
    const auto advice = adviceOn(with(10.0, 300.0));
    ASSERT_EQ(advice.size(), 1U);
    EXPECT_THAT(advice.front().what.toStdString(), HasSubstr("The permitted 50.0 Nm are enough for a moment of inertia "
                                                             "of at most 9.5 kg·m², without friction and wind"));
    EXPECT_THAT(advice.front().remedy.toStdString(), HasSubstr("Lower max_acceleration_deg_s2 (300.0)"));
}

// Story: 300°/s² with 5 Nm and 30°/s passed the check, because full speed took just a tenth of a second.
TEST(Advice, TellsOfATorqueThatTurnsNothing)
{
    for (const auto& [speed, acceleration, torque] : {std::tuple(30.0, 299.0, 5.0), std::tuple(10.0, 90.0, 2.0)}) {
        const auto advice = adviceOn(with(speed, acceleration, torque));
        ASSERT_EQ(advice.size(), 1U) << torque;
        EXPECT_THAT(advice.front().remedy.toStdString(), HasSubstr("or raise max_torque_nm"));
    }
    EXPECT_THAT(
        adviceOn(with(10.0, 90.0, 2.0)).front().what.toStdString(),
        HasSubstr(
            "The permitted 2.0 Nm are enough for a moment of inertia of at most 1.3 kg·m², without friction and wind"));
    EXPECT_TRUE(adviceOn(with(10.0, 30.0, 2.0)).empty()) << "3.8 kg·m²";
}

TEST(Advice, LooksAtBothAxes)
{
    Profile profile = with(7.0, 0.5);
    profile.elevation.limits = profile.azimuth.limits;
    EXPECT_EQ(adviceOn(profile).size(), 2U);
}

// REQ-PROFILE-966
TEST(Advice, TellsOfStepsWithoutEffect)
{
    Profile profile;
    profile.elevation.stepsPerTurn = 866.0;
    ASSERT_EQ(adviceOn(profile).size(), 1U);
    EXPECT_EQ(adviceOn(profile).front().key, "elevation.steps_per_turn");
    profile.elevation.driver = AxisDriver::Rotctld;
    EXPECT_TRUE(adviceOn(profile).empty());
}

// REQ-PROFILE-964: Settings of Hamlib that have no effect, because Boresight starts no rotctld for this bus, give
// advice.
TEST(Advice, TellsOfSettingsOfHamlibWithoutEffect)
{
    Profile profile;
    profile.hamlibSettings = {"min_az=-90"};
    for (const char* const without : {"rotctld:10.0.0.7:4533", "serial:/dev/ttyUSB0"}) {
        profile.bus = without;
        ASSERT_EQ(adviceOn(profile).size(), 1U) << without;
        EXPECT_EQ(adviceOn(profile).front().key, "bus.hamlib_settings");
    }
    for (const char* const with : {"hamlib:901:/dev/ttyUSB0", "simulated"}) {
        profile.bus = with;
        EXPECT_TRUE(adviceOn(profile).empty()) << with;
    }
}

// REQ-MOUNT-12
TEST(Advice, TellsWhatAMountWithOneAxisDoesNotUse)
{
    Profile profile;
    profile.elevation.driver = AxisDriver::None;
    profile.pointing.azimuthOffset = 30_deg;
    EXPECT_TRUE(adviceOn(profile).empty());
    profile.pointing.collimation = 1_deg;
    ASSERT_EQ(adviceOn(profile).size(), 1U);
    EXPECT_EQ(adviceOn(profile).front().key, "pointing");
    profile.elevation.driver = AxisDriver::Moteus;
    EXPECT_TRUE(adviceOn(profile).empty());
}

}  // namespace
}  // namespace boresight::profile
