// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/axis_plant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace boresight::sim {
namespace {

constexpr double kStep = 1e-3;

void run(AxisPlant& plant, double seconds, const PlantLoads& loads)
{
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep)); ++i) {
        plant.step(kStep, loads);
    }
}

const PlantSettings kFrictionless{
    .inertia = 10.0, .coulombFriction = 0.0, .staticFriction = 0.0, .viscousFriction = 0.0};

TEST(AxisPlant, TorqueAcceleratesInertia)
{
    AxisPlant plant(kFrictionless, 0.0);
    run(plant, 2.0, {.driveTorque = 5.0});  // 0.5 rad/s²
    EXPECT_NEAR(plant.velocity() * 2.0 * std::numbers::pi, 1.0, 1e-9);
    EXPECT_NEAR(plant.position() * 2.0 * std::numbers::pi, 1.0, 1e-3);
}

TEST(AxisPlant, StaticFrictionHoldsUntilItBreaksAway)
{
    AxisPlant plant({.inertia = 10.0, .coulombFriction = 3.0, .staticFriction = 4.0, .viscousFriction = 0.0}, 0.0);
    run(plant, 1.0, {.driveTorque = 3.9});
    EXPECT_EQ(plant.velocity(), 0.0);
    run(plant, 1.0, {.driveTorque = 4.1});
    EXPECT_NEAR(plant.velocity() * 2.0 * std::numbers::pi, 1.1 / 10.0, 1e-3) << "only 3 Nm while moving";
    run(plant, 5.0, {});
    EXPECT_EQ(plant.velocity(), 0.0) << "friction stops and never reverses";
}

TEST(AxisPlant, FrictionlessPendulumKeepsItsEnergy)
{
    PlantSettings settings = kFrictionless;
    settings.gravityTorque = 10.0;  // no torque a quarter turn from level: the axis swings about 0.25
    AxisPlant plant(settings, 0.2);
    double most = 0.0;
    for (int i = 0; i < 60000; ++i) {
        plant.step(kStep, {});
        most = std::max(most, std::abs(plant.position() - 0.25));
    }
    EXPECT_NEAR(most, 0.05, 0.002) << "a minute later the swing has not grown";
}

TEST(AxisPlant, EndStopsAreHard)
{
    PlantSettings settings = kFrictionless;
    settings.stopMax = 0.1;
    AxisPlant plant(settings, 0.0);
    run(plant, 5.0, {.driveTorque = 5.0});
    EXPECT_EQ(plant.position(), 0.1);
    EXPECT_EQ(plant.velocity(), 0.0);
    run(plant, 1.0, {.driveTorque = -5.0});
    EXPECT_LT(plant.position(), 0.1);
}

TEST(AxisPlant, JamBlocksFromBothSidesAndClears)
{
    for (const double start : {0.0, 0.1}) {
        AxisPlant plant(kFrictionless, start);
        plant.setJam(0.05);
        const double torque = start < 0.05 ? 5.0 : -5.0;
        run(plant, 5.0, {.driveTorque = torque});
        EXPECT_NEAR(plant.position(), 0.05, 1e-3);
        EXPECT_NE(plant.position(), 0.05);
        plant.setJam(std::nullopt);
        run(plant, 1.0, {.driveTorque = torque});
        EXPECT_GT(std::abs(plant.position() - 0.05), 0.01);
    }
}

TEST(AxisPlant, StallHoldsAgainstAnything)
{
    AxisPlant plant(kFrictionless, 0.3);
    plant.setStalled(true);
    run(plant, 1.0, {.driveTorque = 500.0});
    EXPECT_EQ(plant.position(), 0.3);
    EXPECT_EQ(plant.velocity(), 0.0);
}

TEST(AxisPlant, LoadFollowsBehindTheBacklash)
{
    PlantSettings settings = kFrictionless;
    settings.staticFriction = 4.0;
    settings.backlash = 0.002;
    AxisPlant plant(settings, 0.0);
    run(plant, 1.0, {.driveTorque = 5.0});
    EXPECT_NEAR(plant.loadPosition(), plant.position() - 0.001, 1e-9) << "dragged";
    run(plant, 3.0, {.driveTorque = -5.0});
    EXPECT_NEAR(plant.loadPosition(), plant.position() + 0.001, 1e-9) << "pushed from the other flank";
    run(plant, 0.5, {.driveTorque = -5.0, .windTorque = -3.0});
    EXPECT_NEAR(plant.loadPosition(), plant.position() - 0.001, 1e-9) << "wind takes up the gap";
}

// REQ-TUNING-20: If configured, the simulated gear has a gap in which the motor feels no friction of the load.
TEST(AxisPlant, TheMotorDoesNotFeelTheLoadInsideTheGap)
{
    AxisPlant plant({.inertia = 10.0,
                     .coulombFriction = 4.0,
                     .staticFriction = 4.0,
                     .viscousFriction = 5.0,
                     .backlash = 0.002,
                     .loadShare = 0.5},
                    0.0);
    run(plant, 2.0, {.driveTorque = 6.0});
    run(plant, 2.0, {});
    const double turned = plant.position();
    // more than the motor's own friction, less than the friction of motor and load
    run(plant, 5.0, {.driveTorque = -2.2});
    EXPECT_NEAR(plant.position(), turned - 0.002, 3e-4) << "across the gap, and no farther";
    EXPECT_EQ(plant.velocity(), 0.0);
    run(plant, 1.0, {.driveTorque = -6.0});
    EXPECT_LT(plant.position(), turned - 0.003);
    EXPECT_NEAR(plant.loadPosition(), plant.position() + 0.001, 1e-9);
}

}  // namespace
}  // namespace boresight::sim
