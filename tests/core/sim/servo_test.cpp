// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/servo.h"

#include "core/sim/reference_mount.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace boresight::sim {
namespace {

using moteus::Mode;

constexpr double kServoStep = 1e-3;

// One drive and its axis, without noise, with a stiff 24 V supply.
class ServoOnPlant : public testing::Test
{
protected:
    ServoOnPlant()
        : config(commissionedDrive(Axis::Elevation)),
          plant(referenceAxis(Axis::Elevation).plant, referenceAxis(Axis::Elevation).toTurns(45.0_deg))
    {}

    void run(double seconds)
    {
        for (int i = 0; i < static_cast<int>(std::lround(seconds / kServoStep)); ++i) {
            inputs.position = plant.position();
            inputs.velocity = plant.velocity();
            const ServoOutput& out = servo.step(kServoStep, inputs);
            plant.step(kServoStep, {.driveTorque = out.torque,
                                    .brakeDamping = out.braking ? brakeDamping(config) : 0.0,
                                    .windTorque = wind});
            lowestPower = std::min(lowestPower, out.power);
        }
    }
    // Holds the present position. Without an argument there is no watchdog.
    void hold(double watchdog = kNone)
    {
        servo.command({.mode = Mode::Position, .position = kNone, .watchdogTimeout = watchdog});
        run(0.05);
    }
    // Three times the torque that friction can hold.
    void unbalance() { plant.settings().gravityTorque = 30.0; }

    DriveConfig config;
    Servo servo{config};
    AxisPlant plant;
    ServoInputs inputs;
    double wind = 0.0;
    double lowestPower = 0.0;
};

constexpr double degrees(double turns)
{
    return turns * 360.0;
}

// 30 Nm against 5.5 Nm of friction on 12 kg·m² during 13.5 ms without power: ½·a·t² = 0.009°.
// REQ-SIM-03: Enabling the driver takes 13 ms without power, in which an unbalanced elevation axis sags.
TEST_F(ServoOnPlant, UnbalancedElevationSagsWhileTheDriverIsEnabled)
{
    unbalance();
    plant.settings().staticFriction = 5.5;
    plant.settings().gravityTorque = 30.0 / std::cos(std::numbers::pi / 4.0);  // 30 Nm at 45°
    const double start = plant.position();
    servo.command({.mode = Mode::Position, .position = kNone, .watchdogTimeout = kNone});
    run(0.014);
    EXPECT_NE(servo.mode(), Mode::Stopped);
    EXPECT_NEAR(degrees(plant.position() - start), 0.5 * (24.5 / 12.0) * 0.0135 * 0.0135 * 180.0 / std::numbers::pi,
                0.003);
    run(1.0);
    EXPECT_LT(std::abs(plant.velocity()), 1e-4) << "caught by position control";
}

TEST_F(ServoOnPlant, ReferenceElevationStaysWithoutPower)
{
    const double start = plant.position();
    run(10.0);
    EXPECT_DOUBLE_EQ(plant.position(), start);
}

// REQ-SIM-04
TEST_F(ServoOnPlant, LoadedAxisCreepsInZeroVelocity)
{
    unbalance();
    config.servo.timeoutMode = 12;
    hold(0.1);
    const double start = plant.position();
    run(0.5);
    EXPECT_EQ(servo.mode(), Mode::PositionTimeout);
    EXPECT_EQ(servo.faultCode(), static_cast<int>(ActiveLimit::CommandedTorque)) << "5 Nm are not enough";
    EXPECT_GT(degrees(plant.position() - start), 1.0) << "down is towards positive turns";
}

// REQ-SIM-04: Time-out modes 0, 10, 12 and 15 let the axis fall, hold it, let it creep, and damp it.
TEST_F(ServoOnPlant, TimeoutModeHoldKeepsALoadedAxis)
{
    unbalance();
    hold(0.1);
    run(5.0);
    EXPECT_EQ(servo.mode(), Mode::PositionTimeout);
    EXPECT_NEAR(degrees(plant.position()), degrees(servo.control().position), 0.002);
    EXPECT_NEAR(degrees(plant.position()), -135.0, 0.1) << "at 45° of elevation as before, but for the sag";
}

// REQ-SIM-04
TEST_F(ServoOnPlant, TimeoutModeOffLetsALoadedAxisFall)
{
    unbalance();
    config.servo.timeoutMode = 0;
    hold(0.1);
    run(3.0);
    EXPECT_NEAR(plant.position(), plant.settings().stopMax, 1e-9) << "falls to the end stop";
}

// REQ-SIM-04
TEST_F(ServoOnPlant, TimeoutModeBrakeDampsButDoesNotHold)
{
    unbalance();
    config.servo.timeoutMode = 15;
    hold(0.1);
    const double start = plant.position();
    run(1.0);
    EXPECT_GT(plant.position(), start);
    // Terminal speed: gravity minus friction, divided by the damping of the shorted motor.
    const double expected = (30.0 * std::cos(std::numbers::pi / 4.0) - 5.5) / (brakeDamping(config) + 5.0);
    EXPECT_NEAR(plant.velocity() * 2.0 * std::numbers::pi, expected, 0.2 * expected);
}

// 6°/s when the last command arrives: watchdog 0.1 s, then the default deceleration.
// REQ-SIM-05: 0.2 s after the last command at full speed the axis is slower than 0.3°/s.
TEST_F(ServoOnPlant, WatchdogStopsAMovingAxisWithinTwoTenths)
{
    const ServoCommand full{.mode = Mode::Position,
                            .position = kNone,
                            .velocity = 8.0 / 360.0,
                            .watchdogTimeout = 2.0,
                            .accelerationLimit = 0.05};
    servo.command(full);
    run(1.9);
    ASSERT_NEAR(degrees(plant.velocity()), 8.0, 0.05);
    ServoCommand last = full;
    last.watchdogTimeout = 0.1;
    servo.command(last);
    run(0.2);
    EXPECT_EQ(servo.mode(), Mode::PositionTimeout);
    EXPECT_LT(std::abs(degrees(plant.velocity())), 0.3);
}

// As in the firmware: 2·pi · kg·m² · turns/s² of its own planner.
TEST_F(ServoOnPlant, InertiaFeedforwardGivesTheTorqueOfThePlannedAcceleration)
{
    config.servo.inertiaFeedforward = 20.0;
    const ServoCommand start{.mode = Mode::Position, .position = kNone, .velocity = 0.02, .accelerationLimit = 0.05};
    servo.command(start);
    run(0.02);
    servo.command(start);
    run(0.01);
    const double pid = servo.terms().proportional + servo.terms().integral + servo.terms().derivative;
    EXPECT_NEAR(servo.terms().total - pid, 20.0 * 2.0 * std::numbers::pi * 0.05, 1e-9);
}

TEST_F(ServoOnPlant, BrakingFeedsPowerBack)
{
    servo.command({.mode = Mode::Position,
                   .position = kNone,
                   .velocity = -0.04,
                   .watchdogTimeout = kNone,
                   .velocityLimit = 0.05,
                   .accelerationLimit = 0.2});
    run(1.0);
    lowestPower = 0.0;
    servo.command({.mode = Mode::Position, .position = kNone, .watchdogTimeout = kNone, .accelerationLimit = 0.2});
    run(0.5);
    EXPECT_LT(lowestPower, -0.3);
}

// REQ-SIM-06
TEST_F(ServoOnPlant, StalledAxisRunsIntoTheTorqueLimit)
{
    hold();
    plant.setStalled(true);
    const double target = plant.position() - 0.02;  // 7.2°: the drive gives up at 10°
    servo.command({.mode = Mode::Position,
                   .position = target,
                   .maximumTorque = 40.0,
                   .watchdogTimeout = kNone,
                   .velocityLimit = 0.02,
                   .accelerationLimit = 0.05});
    run(3.0);
    EXPECT_EQ(servo.mode(), Mode::Position);
    EXPECT_EQ(servo.faultCode(), static_cast<int>(ActiveLimit::CommandedTorque));
    EXPECT_NEAR(std::abs(servo.output().torque), 40.0, 1e-9);
    plant.setStalled(false);
    run(3.0);
    EXPECT_NEAR(plant.position(), target, 1e-4);
    EXPECT_EQ(servo.faultCode(), 0);
}

TEST_F(ServoOnPlant, AStalledAxisFarBehindItsOrderFaults)
{
    hold();
    plant.setStalled(true);
    servo.command({.mode = Mode::Position,
                   .position = plant.position() - 0.05,
                   .watchdogTimeout = kNone,
                   .velocityLimit = 0.02,
                   .accelerationLimit = 0.05});
    run(3.0);
    EXPECT_EQ(servo.mode(), Mode::Fault);
    EXPECT_EQ(servo.faultCode(), 49);
}

// After a time-out the drive holds by position control, and gives up at the same distance as before.
TEST_F(ServoOnPlant, AnAxisPushedFarFromWhereItHoldsAfterATimeoutFaults)
{
    hold(0.1);
    run(0.2);
    ASSERT_EQ(servo.mode(), Mode::PositionTimeout);
    const double held = servo.control().position;
    wind = 120.0;  // the drive has 83 Nm
    for (int i = 0; i < 3000 && degrees(std::abs(plant.position() - held)) < 9.9; ++i) {
        run(kServoStep);
    }
    EXPECT_EQ(servo.mode(), Mode::PositionTimeout);
    run(0.1);
    EXPECT_EQ(servo.mode(), Mode::Fault);
    EXPECT_EQ(servo.faultCode(), 49);
}

TEST_F(ServoOnPlant, ABrakedAxisHasNoDistanceToKeep)
{
    config.servo.timeoutMode = 15;
    hold(0.1);
    run(0.2);
    const double held = plant.position();
    wind = 120.0;
    run(2.0);
    EXPECT_GT(degrees(std::abs(plant.position() - held)), 10.0);
    EXPECT_EQ(servo.mode(), Mode::PositionTimeout);
}

TEST_F(ServoOnPlant, PushedOutsideTheBoundsTheOutwardCurrentFades)
{
    config.servo.gains.ilimit = 0.0;
    hold();
    config.positionMax = plant.position() - 0.01;
    servo.command({.mode = Mode::Position,
                   .position = kNone,
                   .feedforwardTorque = 700.0,
                   .kpScale = 0.0,
                   .maximumTorque = 70.0,
                   .watchdogTimeout = kNone});
    run(0.002);
    EXPECT_EQ(servo.faultCode(), static_cast<int>(ActiveLimit::PositionBounds));
    EXPECT_LT(servo.output().torque, 40.0) << "half of 70 Nm is left 0.01 turns outside";
    EXPECT_GT(servo.output().torque, 30.0);
}

// REQ-SIM-940: A velocity without a position ends at the drive's own position bounds, as in the firmware. Only a
// command that ignores the bounds runs on.
TEST_F(ServoOnPlant, AVelocityEndsAtTheBounds)
{
    hold();
    config.positionMax = plant.position() + 0.01;
    ServoCommand turn{.mode = Mode::Position,
                      .position = kNone,
                      .velocity = 0.02,
                      .watchdogTimeout = kNone,
                      .accelerationLimit = 0.1};
    servo.command(turn);
    run(2.0);
    EXPECT_EQ(servo.mode(), Mode::Position);
    EXPECT_EQ(servo.control().position, config.positionMax);
    EXPECT_NEAR(plant.position(), config.positionMax, 0.001);
    turn.ignorePositionBounds = true;
    servo.command(turn);
    run(1.0);
    EXPECT_GT(plant.position(), config.positionMax + 0.01);
}

TEST_F(ServoOnPlant, StayWithinPushesBackOnlyOutside)
{
    const double here = plant.position();
    servo.command({.mode = Mode::StayWithin,
                   .watchdogTimeout = kNone,
                   .stayWithinLower = here - 0.1,
                   .stayWithinUpper = here + 0.1});
    run(0.1);
    EXPECT_EQ(servo.output().torque, 0.0);
    servo.command(
        {.mode = Mode::StayWithin, .watchdogTimeout = kNone, .stayWithinLower = kNone, .stayWithinUpper = here - 0.01});
    run(3.0);
    EXPECT_LT(plant.position(), here - 0.01 + 1e-4);
    EXPECT_GT(plant.position(), here - 0.015) << "and no further than it coasts";
}

// The factory setting switches the integrator off: a constant load causes an error of torque/kp.
TEST_F(ServoOnPlant, WithoutIntegratorALoadCostsAConstantError)
{
    config.servo.gains.ilimit = 0.0;
    plant.settings() = {.inertia = 12.0, .coulombFriction = 0.0, .staticFriction = 0.0};
    hold();
    const double held = servo.control().position;
    wind = 20.0;
    run(3.0);
    EXPECT_NEAR(plant.position() - held, 20.0 / config.servo.gains.kp, 2e-6);
}

TEST_F(ServoOnPlant, SlipLimitKeepsTheSetPointWithABlockedAxis)
{
    config.servo.maxPositionSlip = 0.01;
    hold();
    plant.setStalled(true);
    servo.command({.mode = Mode::Position, .position = kNone, .velocity = -0.02, .watchdogTimeout = kNone});
    run(5.0);
    EXPECT_NEAR(servo.control().position, plant.position() - 0.01, 1e-9);
}

TEST_F(ServoOnPlant, ShiftedFrameMovesNothing)
{
    hold();
    run(1.0);
    const double before = plant.position();
    plant.place(before + 1.0);  // the same position with another origin of the count
    plant.settings().stopMax += 1.0;
    plant.settings().levelAt += 1.0;
    config.positionMax += 1.0;
    servo.shiftFrame(1.0);
    run(1.0);
    EXPECT_NEAR(plant.position(), before + 1.0, 1e-5);
}

// Kv 300 at 100:1 gives 2.76 Nm/A, so 30 A give 82.7 Nm.
// REQ-SIM-06 (CurrentLimits.*): Limits 96…104 act and are reported. A blocked axis reports torque.
TEST(CurrentLimits, TorqueFollowsKvAndRatio)
{
    const DriveConfig config = commissionedDrive(Axis::Azimuth);
    EXPECT_NEAR(torquePerAmpere(config), 8.27 / 300.0 * 100.0, 1e-9);
    const LimitedCurrent limited = limitedCurrent(200.0, config, {});
    EXPECT_EQ(limited.limit, ActiveLimit::MaxCurrent);
    EXPECT_NEAR(limited.amperes * torquePerAmpere(config), 82.7, 0.01);
}

TEST(CurrentLimits, HeatSpeedPowerAndVoltageReduceTheCurrent)
{
    DriveConfig config = commissionedDrive(Axis::Azimuth);
    const auto limit = [&](double wanted, const ElectricalState& state) {
        return limitedCurrent(wanted, config, state);
    };
    EXPECT_EQ(limit(30.0, {.fetTemperature = 62.5}).limit, ActiveLimit::FetTemperature);
    EXPECT_NEAR(limit(30.0, {.fetTemperature = 62.5}).amperes, 15.0, 1e-9);
    EXPECT_EQ(limit(10.0, {.velocity = 0.065}).limit, ActiveLimit::MaxVelocity);
    EXPECT_EQ(limit(-10.0, {.velocity = 0.065}).limit, ActiveLimit::None) << "braking is not reduced";
    config.servo.maxVelocity = 500.0;
    EXPECT_EQ(limit(30.0, {.velocity = 0.9}).limit, ActiveLimit::BusVoltage);
    config.servo.maxPower = 20.0;
    EXPECT_EQ(limit(30.0, {.velocity = 0.05}).limit, ActiveLimit::MaxPower);
    config.servo.enableMotorTemperature = true;
    config.servo.motorFaultTemperature = 80.0;
    EXPECT_EQ(limit(30.0, {.motorTemperature = 70.0}).limit, ActiveLimit::MotorTemperature);
}

}  // namespace
}  // namespace boresight::sim
