// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/judge.h"

#include <gtest/gtest.h>

namespace boresight::orientation {
namespace {

SteadyTime at(double second)
{
    return SteadyTime{std::chrono::duration_cast<SteadyTime::duration>(Seconds(second))};
}

Orientation value(double second, double extended, std::int64_t revolutions = 0)
{
    return {.heading = SensorHeading::folded(Angle::fromDegrees(extended)),
            .extendedAzimuth = Angle::fromDegrees(extended),
            .revolutions = revolutions,
            .elevation = 20_deg,
            .temperature = 25.0,
            .calibration = Calibration{.system = 3, .gyro = 3, .accelerometer = 2, .magnetometer = 3},
            .arrival = at(second)};
}

Orientation deadValue(double second)
{
    Orientation dead = value(second, 5.07);
    dead.elevation = Angle{};
    dead.temperature = 0.0;
    dead.calibration = Calibration{};
    return dead;
}

// REQ-ORIENTATION-07 (Judge.*): The sensor is late after 3 s and lost after 5 s (both can be set). A dead sensor,
// single jumps, restarts and frozen values are detected. Turns are counted from headings, and gaps in this count are
// known.
TEST(Judge, LateAfterThreeSecondsLostAfterFive)
{
    Judge judge;
    EXPECT_EQ(judge.presence(at(100.0)), Presence::Awaited);
    EXPECT_EQ(judge.take(value(10.0, 40.0)), ValueFate::Used);
    EXPECT_EQ(judge.presence(at(12.9)), Presence::Present);
    EXPECT_EQ(judge.presence(at(13.0)), Presence::Late);
    EXPECT_EQ(judge.presence(at(14.99)), Presence::Late);
    EXPECT_EQ(judge.presence(at(15.0)), Presence::Lost);
    EXPECT_EQ(judge.take(value(16.0, 40.0)), ValueFate::Used);
    EXPECT_EQ(judge.presence(at(16.0)), Presence::Present);
    judge.setSettings({.lost = Seconds(2.0)});
    EXPECT_EQ(judge.presence(at(18.0)), Presence::Lost);
}

TEST(Judge, TheMarkOfADeadSensorIsNotUsed)
{
    Judge judge;
    EXPECT_EQ(judge.take(deadValue(1.0)), ValueFate::Dead);
    EXPECT_TRUE(judge.dead());
    EXPECT_FALSE(judge.last());
    EXPECT_EQ(judge.take(value(2.0, 5.07)), ValueFate::Used) << "a living one may look there";
    EXPECT_FALSE(judge.dead());
    Orientation turned = deadValue(3.0);
    turned.heading = SensorHeading::folded(725.07_deg);
    EXPECT_EQ(judge.take(turned), ValueFate::Dead) << "with revolutions";
    Orientation warm = deadValue(4.0);
    warm.temperature = 1.0;
    EXPECT_NE(judge.take(warm), ValueFate::Dead);
    Orientation plain = deadValue(5.0);
    plain.temperature.reset();
    plain.calibration.reset();
    EXPECT_EQ(judge.take(plain), ValueFate::Dead) << "by MQTT nothing else is told";
}

// Firmware compiled for another place, or without a declination.
TEST(Judge, TheMarkOfADeadSensorHasTheFirmwaresDeclination)
{
    Judge judge({.declinationInSensor = 12.5_deg});
    EXPECT_EQ(judge.take(deadValue(1.0)), ValueFate::Used) << "5.07° is a heading there";
    Orientation dead = deadValue(20.0);
    dead.heading = SensorHeading::folded(12.5_deg);
    EXPECT_EQ(judge.take(dead), ValueFate::Dead);
    judge.setSettings({.declinationInSensor = -0.004_deg});
    dead.heading = SensorHeading::folded(0_deg);
    EXPECT_EQ(judge.take(dead), ValueFate::Dead) << "on both sides of north";
    judge.setSettings({.declinationInSensor = -3_deg});
    dead.heading = SensorHeading::folded(357_deg);
    EXPECT_EQ(judge.take(dead), ValueFate::Dead);
}

TEST(Judge, AJumpIsRejectedOnceAndBelievedWhenTheNextTwoAgree)
{
    Judge judge;
    judge.take(value(0.0, 100.0));
    EXPECT_EQ(judge.take(value(1.0, 250.0)), ValueFate::Outlier);
    EXPECT_EQ(judge.take(value(2.0, 101.0)), ValueFate::Used) << "it was one alone";
    EXPECT_EQ(judge.take(value(3.0, 250.0)), ValueFate::Outlier);
    EXPECT_EQ(judge.take(value(4.0, 251.0)), ValueFate::Outlier);
    EXPECT_EQ(judge.last()->heading.angle(), (101_deg).wrapped360());
    EXPECT_EQ(judge.take(value(5.0, 252.0)), ValueFate::Used);
    EXPECT_EQ(judge.outliers(), 3U);
    EXPECT_EQ(judge.take(value(6.0, 10.0)), ValueFate::Outlier);
    EXPECT_EQ(judge.take(value(7.0, 100.0)), ValueFate::Outlier) << "neither agrees";
    EXPECT_EQ(judge.take(value(8.0, 100.0)), ValueFate::Outlier);
    EXPECT_EQ(judge.take(value(9.0, 100.0)), ValueFate::Used);
}

TEST(Judge, WhatTheAxisCanDoIsNoJump)
{
    Judge judge({.azimuthSpeed = 20_deg_s, .elevationSpeed = 6_deg_s});
    judge.take(value(0.0, 350.0));
    EXPECT_EQ(judge.take(value(1.0, 374.0, 1)), ValueFate::Used);
    EXPECT_EQ(judge.take(value(3.0, 418.0, 1)), ValueFate::Used) << "in two seconds";
    Orientation high = value(4.0, 418.0, 1);
    high.elevation = 40_deg;
    EXPECT_EQ(judge.take(high), ValueFate::Outlier);
    EXPECT_EQ(judge.take(value(9.0, 200.0)), ValueFate::Used) << "after a loss anything goes";
}

TEST(Judge, CountsTheTurnsItself)
{
    Judge judge({.azimuthSpeed = 60_deg_s});
    double second = 0.0;
    for (double heading = 0.0; heading <= 1090.0; heading += 30.0) {
        judge.take(value(second, heading));
        second += 1.0;
    }
    EXPECT_EQ(judge.turns(), 3);
    for (double heading = 1050.0; heading >= -30.0; heading -= 30.0) {
        judge.take(value(second, heading));
        second += 1.0;
    }
    EXPECT_EQ(judge.turns(), -1);
    EXPECT_EQ(judge.outliers(), 0U);
}

TEST(Judge, NoticesARestart)
{
    Judge judge;
    judge.take(value(0.0, 725.0, 2));
    judge.take(value(1.0, 726.0, 2));
    EXPECT_EQ(judge.restarts(), 0U);
    judge.take(value(4.0, 6.0, 0));
    EXPECT_EQ(judge.restarts(), 1U);
    EXPECT_EQ(judge.turns(), 0) << "its count jumped, the heading did not";

    judge.take(value(5.0, -1.0, -1));
    judge.take(value(6.0, 1.0, 0));
    EXPECT_EQ(judge.restarts(), 1U);
    Orientation fresh = value(9.0, 1.0, 0);
    fresh.calibration = Calibration{};
    judge.take(fresh);
    EXPECT_EQ(judge.restarts(), 2U);
    judge.take(fresh);
    EXPECT_EQ(judge.restarts(), 2U) << "told once";
}

// Story: the mount had turned by 250° while nothing was received from the sensor. The sensor's own count, still at 0,
// looked like a restart.
TEST(Judge, ALongWayUnheardIsNoRestart)
{
    Judge judge;
    judge.take(value(0.0, 350.0, 0));
    judge.take(value(45.0, 100.0, 0));
    EXPECT_EQ(judge.restarts(), 0U);
    judge.take(value(46.0, 98.0, 0));
    judge.take(value(90.0, -150.0, -1));
    EXPECT_EQ(judge.restarts(), 0U);
    judge.take(value(91.0, 210.0, 0));
    EXPECT_EQ(judge.restarts(), 1U) << "360° in a second: that is its count alone";
}

// The course counts whole turns. Between two moments with the same number of breaks it gives the angle turned.
TEST(Judge, ItsCourseIsGoodUntilItBreaks)
{
    Judge judge({.azimuthSpeed = 60_deg_s});
    judge.take(value(0.0, 350.0));
    const auto unbroken = judge.breaks();
    for (int second = 1; second <= 20; ++second) {
        judge.take(value(second, 350.0 + 30.0 * second));
    }
    EXPECT_NEAR(judge.course().degrees(), 950.0, 1e-9);
    judge.take(deadValue(21.0));
    judge.take(value(22.0, 950.0));
    EXPECT_EQ(judge.breaks(), unbroken) << "a false reading alone is none";
    judge.take(value(27.0, 950.0));
    EXPECT_EQ(judge.breaks(), unbroken + 1) << "silent for five seconds";
    judge.setSettings({});
    for (const double second : {28.0, 29.0, 30.0}) {
        judge.take(value(second, 1090.0));
    }
    EXPECT_EQ(judge.breaks(), unbroken + 2) << "a jump that was believed";
    Orientation fresh = value(31.0, 1090.0);
    fresh.calibration = Calibration{};
    judge.take(fresh);
    EXPECT_EQ(judge.breaks(), unbroken + 3) << "restarted";
    judge.forget();
    EXPECT_GT(judge.breaks(), unbroken + 3);
    EXPECT_EQ(judge.course(), Angle());
}

// A sensor that lies face up counts against the compass.
TEST(Judge, CountsAsTheSensorDoes)
{
    Judge judge;
    judge.take(value(0.0, 2.0));
    judge.take(value(1.0, -3.0, -1));
    EXPECT_EQ(judge.turns(), -1);
    EXPECT_NEAR(judge.course().degrees(), -3.0, 1e-9);
}

TEST(Judge, SaysSinceWhenNothingChanges)
{
    Judge judge;
    judge.take(value(1.0, 40.0));
    EXPECT_FALSE(judge.frozenSince());
    judge.take(value(2.0, 40.0));
    judge.take(value(3.0, 40.0));
    EXPECT_EQ(judge.frozenSince(), at(1.0));
    judge.take(value(4.0, 40.01));
    EXPECT_FALSE(judge.frozenSince());
    judge.forget();
    EXPECT_FALSE(judge.last());
}

}  // namespace
}  // namespace boresight::orientation
