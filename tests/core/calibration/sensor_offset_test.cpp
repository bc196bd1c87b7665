// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/sensor_offset.h"

#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace boresight::calibration {
namespace {

using orientation::SensorHeading;
using ::testing::HasSubstr;

std::vector<SensorReading> readings(double heading, double noise, std::size_t count, double memory = 0.0,
                                    unsigned seed = 1)
{
    std::mt19937_64 random(seed);
    std::normal_distribution<double> gaussian;
    std::vector<SensorReading> result;
    double off = noise * gaussian(random);
    for (std::size_t i = 0; i < count; ++i) {
        off = memory * off + std::sqrt(1.0 - memory * memory) * noise * gaussian(random);
        result.push_back({.heading = SensorHeading::folded(Angle::fromDegrees(heading + off)),
                          .axisAzimuth = 100_deg,
                          .axisRate = {},
                          .motorCurrent = 0.1,
                          .systemCalibration = 3,
                          .magnetometerCalibration = 3});
    }
    return result;
}

double offBy(const SensorOffset& offset, double truth)
{
    return (offset.offset.value - Angle::fromDegrees(truth)).wrapped180().degrees();
}

std::string offsetReason(const std::vector<SensorReading>& readings)
{
    const auto offset = sensorOffset(readings);
    return offset ? "accepted" : textOf(offset.error());
}

// REQ-CALIBRATION-01: North from a mount that stands still is a mean over the circle. It is refused with the reason
// while the calibration level is below 2, a motor draws current, the mount moves, or the readings are too few, drift or
// disagree.
TEST(SensorOffset, IsTheMeanOverTheCircle)
{
    const auto offset = sensorOffset(readings(99.9, 0.5, 60));  // headings on both sides of the axis angle
    ASSERT_TRUE(offset.has_value());
    EXPECT_NEAR(offBy(*offset, -0.1), 0.0, 0.25);
    const auto throughNorth = sensorOffset(readings(360.0, 0.5, 60));  // readings such as 359.8° and 0.2°
    ASSERT_TRUE(throughNorth.has_value());
    EXPECT_NEAR(offBy(*throughNorth, 260.0), 0.0, 0.25);
    EXPECT_EQ(throughNorth->used, 60U);
}

// REQ-CALIBRATION-02
TEST(SensorOffset, IsAsUncertainAsTheDeviationThatIsNotSeen)
{
    const auto offset = sensorOffset(readings(137.4, 0.5, 100));
    ASSERT_TRUE(offset.has_value());
    EXPECT_LT(offset->statistical, 0.15_deg);
    EXPECT_NEAR(offset->offset.sigma.degrees(), std::hypot(6.0, 0.5), 0.01);
}

// REQ-CALIBRATION-02
TEST(SensorOffset, UsesTheCurveOfASwing)
{
    DeviationCurve curve;
    curve.a1 = 8_deg;
    curve.b2 = 3_deg;
    curve.scatter = 0.5_deg;
    auto still = readings(0.0, 0.0, 20);
    for (SensorReading& reading : still) {
        reading.heading = curve.reading(137.4_deg);
    }
    const auto offset = sensorOffset(still, {}, curve);
    ASSERT_TRUE(offset.has_value());
    EXPECT_NEAR(offBy(*offset, 37.4), 0.0, 1e-6);
    // The constant of the swing has a default uncertainty. If the curve states its sigma, that value counts.
    EXPECT_NEAR(offset->offset.sigma.degrees(), std::hypot(0.5, 1.6), 0.01);
    curve.constantSigma = 1.3_deg;
    const auto told = sensorOffset(still, {}, curve);
    ASSERT_TRUE(told.has_value());
    EXPECT_NEAR(told->offset.sigma.degrees(), std::hypot(0.5, 1.3), 0.01);
    curve.unreliable = {{.from = 130_deg, .to = 150_deg, .residual = 15_deg}};
    const auto inSteel = sensorOffset(still, {}, curve);
    ASSERT_TRUE(inSteel.has_value());
    EXPECT_GT(inSteel->offset.sigma, 5_deg);
    EXPECT_FALSE(inSteel->isReliableHere);
    EXPECT_TRUE(offset->isReliableHere);
    // Story: the steel had turned the heading out of its own sector, so the result counted as good.
    curve.unreliable = {{.from = 110_deg, .to = 130_deg, .residual = 15_deg}};
    for (SensorReading& reading : still) {
        reading.azimuth = 482.4_deg;
    }
    const auto turnedOut = sensorOffset(still, {}, curve);
    ASSERT_TRUE(turnedOut.has_value());
    EXPECT_FALSE(turnedOut->isReliableHere) << "by the north in force the mount is at 122.4°";
    EXPECT_GT(turnedOut->offset.sigma, 5_deg);
}

// A box face up counts against the compass. The readings of a mount that stands still do not show this: it must be
// known.
// REQ-CALIBRATION-03
TEST(SensorOffset, ASensorMayCountAgainstTheCompass)
{
    const auto still = readings(360.0 - 137.4, 0.5, 60);
    const auto offset = sensorOffset(still, {}, std::nullopt, AzimuthSense::CounterClockwise);
    ASSERT_TRUE(offset.has_value());
    EXPECT_NEAR(offBy(*offset, 37.4), 0.0, 0.25);
}

// Sydney, 12.83° east, with firmware made for Berlin. The firmware adds 5.07° to a heading that counts backwards, so
// this is taken off. Then north is that of the magnetic compass, and the declination of the place is added to north.
TEST(SensorOffset, TheDeclinationIsAddedToNorthWhicheverWayTheSensorCounts)
{
    constexpr double kTruth = 137.4;
    constexpr double kDeclination = 12.83;
    auto still = readings(0.0, 0.0, 20);
    for (SensorReading& reading : still) {
        const Angle sent = Angle::fromDegrees(5.07 - (kTruth - kDeclination));
        reading.heading = SensorHeading::folded(sent - 5.07_deg);
    }
    const auto offset = sensorOffset(still, {}, std::nullopt, AzimuthSense::CounterClockwise);
    ASSERT_TRUE(offset.has_value());
    EXPECT_NEAR(offBy(*offset, kTruth - 100.0 - kDeclination), 0.0, 1e-9);
}

// At another elevation other parts of the iron deflect the needle.
// REQ-CALIBRATION-02
TEST(SensorOffset, IsLessCertainAwayFromTheElevationOfTheSwing)
{
    DeviationCurve curve;
    curve.a1 = 8_deg;
    curve.scatter = 0.5_deg;
    curve.constantSigma = 1.3_deg;
    curve.elevation = 20_deg;
    const auto sigmaAt = [&](std::optional<Angle> elevation) {
        auto still = readings(137.4, 0.5, 60);
        for (SensorReading& reading : still) {
            reading.axisElevation = elevation;
        }
        return sensorOffset(still, {}, curve)->offset.sigma.degrees();
    };
    EXPECT_NEAR(sigmaAt(20_deg), 1.4, 0.1);
    EXPECT_NEAR(sigmaAt(std::nullopt), 1.4, 0.1) << "not told, not reckoned with";
    EXPECT_NEAR(sigmaAt(80_deg), std::hypot(std::hypot(1.4, 2.0), 8.0 / std::sqrt(2.0)), 0.1);  // 2 sin(60°/2) = 1
}

// Noise that is correlated between readings averages out more slowly. The true error is nearly always within two of the
// statistical sigmas. It would not be if the readings counted as independent.
// REQ-CALIBRATION-02: The sigma allows for noise that is correlated between readings, and for the deviation that one
// heading does not show. After a swing the curve is used, with the sigma of its constant and of the change with
// elevation.
TEST(SensorOffset, ReckonsWithNoiseThatLasts)
{
    int inside = 0;
    int insideIfIndependent = 0;
    constexpr unsigned kRuns = 300;
    for (unsigned seed = 1; seed <= kRuns; ++seed) {
        const auto offset = sensorOffset(readings(137.4, 0.5, 120, 0.7, seed));
        ASSERT_TRUE(offset.has_value());
        const double error = std::abs(offBy(*offset, 37.4));
        inside += error < 2.0 * offset->statistical.degrees() ? 1 : 0;
        insideIfIndependent += error < 2.0 * offset->scatter.degrees() / std::sqrt(120.0) ? 1 : 0;
    }
    EXPECT_GE(inside, kRuns * 92 / 100);
    EXPECT_LT(insideIfIndependent, kRuns * 75 / 100);
}

TEST(SensorOffset, LeavesOutWhatPointsAnywhere)
{
    auto still = readings(137.4, 0.5, 60);
    still[10].heading = SensorHeading::folded(300_deg);
    still[11].heading = SensorHeading::folded(20_deg);
    const auto offset = sensorOffset(still);
    ASSERT_TRUE(offset.has_value());
    EXPECT_GE(offset->rejected, 2U);
    EXPECT_NEAR(offBy(*offset, 37.4), 0.0, 0.25);
}

// REQ-CALIBRATION-01
TEST(SensorOffset, IsRefusedWithTheReason)
{
    auto still = readings(137.4, 0.5, 30);
    EXPECT_EQ(offsetReason(still), "accepted");

    auto bad = still;
    bad[3].magnetometerCalibration = 1;
    EXPECT_THAT(offsetReason(bad), HasSubstr("Magnetometer calibration is 1 of 3, but 2 is needed."));
    bad = still;
    bad[3].systemCalibration = 0;
    EXPECT_THAT(offsetReason(bad), HasSubstr("System calibration of the sensor is 0 of 3, but"));
    bad = still;
    bad[3].motorCurrent = 2.5;
    EXPECT_THAT(offsetReason(bad),
                HasSubstr("Motor current 2.5 A disturbs the compass (limit 1.0 A, sensor.still_current_a)."));
    EXPECT_TRUE(sensorOffset(bad, {.motorCurrent = 3.0})) << "a limit that is set";
    bad = still;
    bad[3].motorCurrent = std::nan("");
    EXPECT_THAT(offsetReason(bad), HasSubstr("Motor current"));
    bad = still;
    bad[3].axisRate = 1_deg_s;
    EXPECT_THAT(offsetReason(bad), HasSubstr("The mount is moving"));
    bad = still;
    bad[3].axisAzimuth = 101_deg;
    EXPECT_THAT(offsetReason(bad), HasSubstr("The mount is moving"));
    EXPECT_THAT(offsetReason(readings(137.4, 0.5, 9)), HasSubstr("There are 9 readings, but 10 are needed."));
    EXPECT_THAT(offsetReason({}), HasSubstr("There are 0 readings, but"));
    // By MQTT no calibration level is received, and a chip that hangs repeats its readings.
    auto frozen = readings(137.4, 0.0, 20);
    EXPECT_EQ(offsetReason(frozen), "accepted");
    for (SensorReading& reading : frozen) {
        reading.magnetometerCalibration.reset();
        reading.systemCalibration.reset();
    }
    EXPECT_THAT(offsetReason(frozen), HasSubstr("The sensor repeats one value to the last digit"));
    auto drifting = readings(137.4, 0.0, 40);
    for (std::size_t i = 0; i < drifting.size(); ++i) {
        drifting[i].heading = SensorHeading::folded(Angle::fromDegrees(137.4 + 0.05 * static_cast<double>(i)));
    }
    EXPECT_THAT(offsetReason(drifting), HasSubstr("The readings drift"));
    EXPECT_THAT(offsetReason(readings(137.4, 20.0, 40)), HasSubstr("The readings disagree"));
}

TEST(SensorOffset, AcceptsASensorThatDoesNotTellItsCalibration)
{
    auto still = readings(137.4, 0.5, 30);
    for (SensorReading& reading : still) {
        reading.magnetometerCalibration.reset();
        reading.systemCalibration.reset();
    }
    const auto offset = sensorOffset(still);
    ASSERT_TRUE(offset.has_value());
    EXPECT_FALSE(offset->calibrationKnown);
}

}  // namespace
}  // namespace boresight::calibration
