// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/cross_scan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace boresight::calibration {
namespace {

using ::testing::HasSubstr;

struct Source
{
    double at = 0.0;       // degrees
    double width = 10.0;   // half-power, degrees
    double rise = 1000.0;  // of its power over the receiver's own noise
    double noise = 0.0;    // dB
};

// A Gaussian beam over a source, and the receiver's own noise at -100 dB.
std::vector<ScanReading> scan(const Source& source, double reach, int count, unsigned seed = 1)
{
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise;
    std::vector<ScanReading> readings;
    for (int i = 0; i < count; ++i) {
        const double x = -reach + 2.0 * reach * i / (count - 1);
        const double away = (x - source.at) / source.width;
        const double power = source.rise * std::exp(-4.0 * std::log(2.0) * away * away) + 1.0;
        readings.push_back({.offset = Angle::fromDegrees(x),
                            .decibels = -100.0 + 10.0 * std::log10(power) + source.noise * noise(random)});
    }
    return readings;
}

std::string reason(const std::vector<ScanReading>& readings)
{
    const auto peak = fitScan(readings);
    return peak ? "accepted" : peak.error().text;
}

TEST(CrossScan, FindsPeakAndWidth)
{
    const auto peak = fitScan(scan({.at = 1.7, .width = 10.0, .rise = 1e6}, 8.0, 33));
    ASSERT_TRUE(peak.has_value());
    EXPECT_NEAR(peak->offset.value.degrees(), 1.7, 1e-3);
    EXPECT_NEAR(peak->halfPowerWidth.degrees(), 10.0, 0.01);
    EXPECT_NEAR(peak->decibels, -40.0, 0.01);
}

TEST(CrossScan, TheSigmaIsHonest)
{
    int inside = 0;
    constexpr unsigned kRuns = 300;
    for (unsigned seed = 1; seed <= kRuns; ++seed) {
        const auto peak = fitScan(scan({.at = -0.9, .rise = 1e5, .noise = 0.2}, 6.0, 25, seed));
        ASSERT_TRUE(peak.has_value());
        EXPECT_LT(peak->offset.sigma, 0.5_deg);
        inside += std::abs(peak->offset.value.degrees() + 0.9) < 2.0 * peak->offset.sigma.degrees() ? 1 : 0;
    }
    EXPECT_GE(inside, kRuns * 92 / 100);
}

// The Sun in a small dish doubles the noise, no more: as a parabola in dB that peak is far too wide.
TEST(CrossScan, TakesTheBackgroundAway)
{
    const auto readings = scan({.at = 0.8, .rise = 1.0}, 12.0, 49);
    const auto peak = fitScan(readings, {.background = -100.0});
    ASSERT_TRUE(peak.has_value());
    EXPECT_NEAR(peak->offset.value.degrees(), 0.8, 1e-3);
    EXPECT_NEAR(peak->halfPowerWidth.degrees(), 10.0, 0.05);
    EXPECT_GT(fitScan(scan({.at = 0.8, .rise = 1.0}, 6.0, 25))->halfPowerWidth, 12_deg);
}

TEST(CrossScan, IsNotLedAstrayBySideLobesAndSpikes)
{
    auto readings = scan({.at = 1.0, .rise = 1e6, .noise = 0.1}, 8.0, 33);
    readings[16].decibels += 3.0;  // interference
    readings[0].decibels = -45.0;  // a side lobe
    readings[1].decibels = -44.0;
    const auto peak = fitScan(readings);
    ASSERT_TRUE(peak.has_value());
    EXPECT_NEAR(peak->offset.value.degrees(), 1.0, 0.2);
}

// The two lines as a mount sees them, by the true angle between the beam and a source on the sphere.
TEST(CrossScan, TheGeometryOfTheSphereIsReckonedWith)
{
    const AxisPosition middle{.azimuth = 100_deg, .elevation = 75_deg};
    const AxisPosition source{.azimuth = 116_deg, .elevation = 76_deg};
    const auto power = [&](Angle azimuth, Angle elevation) {
        const double cosine = std::sin(elevation.radians()) * std::sin(source.elevation.radians()) +
                              std::cos(elevation.radians()) * std::cos(source.elevation.radians()) *
                                  std::cos((azimuth - source.azimuth).radians());
        const double away = Angle::fromRadians(std::acos(cosine)).degrees() / 10.0;
        return -12.0 * away * away;
    };
    std::vector<ScanReading> across;
    std::vector<ScanReading> elevation;
    for (int i = -20; i <= 20; ++i) {
        const Angle offset = Angle::fromDegrees(0.4 * i);
        across.push_back(
            {offset, power(middle.azimuth + offset / std::cos(middle.elevation.radians()), middle.elevation)});
        elevation.push_back({offset, power(middle.azimuth, middle.elevation + offset)});
    }
    const auto cross = fitCrossScan(middle, across, elevation);
    ASSERT_TRUE(cross.has_value());
    EXPECT_NEAR(cross->peak.azimuth.degrees(), 116.0, 0.05);
    EXPECT_NEAR(cross->peak.elevation.degrees(), 76.0, 0.02);
}

// Somebody's transmitter nearby, and a reading that was lost.
TEST(CrossScan, OneReadingFarOffIsNotThePeak)
{
    auto readings = scan({.at = 1.0, .rise = 1e6, .noise = 0.1}, 8.0, 33);
    readings[5].decibels += 18.0;
    readings[18].decibels -= 15.0;
    const auto peak = fitScan(readings);
    ASSERT_TRUE(peak.has_value()) << peak.error().text;
    EXPECT_NEAR(peak->offset.value.degrees(), 1.0, 0.1);
}

TEST(CrossScan, IsRefusedWithTheReason)
{
    EXPECT_EQ(reason(scan({}, 6.0, 25)), "accepted");
    EXPECT_THAT(reason(scan({.at = 9.0}, 6.0, 25)),
                HasSubstr("the peak is not inside this line: move its middle by +6.0° or more"));
    EXPECT_THAT(reason(scan({.at = -9.0}, 6.0, 25)), HasSubstr("by -6.0° or more"));
    EXPECT_THAT(reason(scan({.rise = 0.0}, 6.0, 25)), HasSubstr("dB only along this line"));
    EXPECT_THAT(reason(scan({}, 6.0, 5)), HasSubstr("5 readings show the source"));
    EXPECT_THAT(reason(scan({}, 60.0, 25)), HasSubstr("scan in smaller steps"));
    auto valley = scan({}, 6.0, 25);
    for (ScanReading& reading : valley) {
        reading.decibels = -reading.decibels;
    }
    EXPECT_NE(reason(valley), "accepted");
    valley[2].decibels = std::nan("");
    EXPECT_THAT(reason(valley), HasSubstr("not a number"));
    EXPECT_THAT(reason({}), HasSubstr("0 readings"));
}

TEST(CrossScan, BothLinesGiveThePlaceOfTheAxes)
{
    const auto cross = fitCrossScan({.azimuth = 370_deg, .elevation = 60_deg}, scan({.at = 1.5, .rise = 1e6}, 8.0, 33),
                                    scan({.at = -0.5, .rise = 1e6}, 8.0, 33));
    ASSERT_TRUE(cross.has_value());
    EXPECT_NEAR(cross->peak.azimuth.degrees(), 370.0 + 1.5 / 0.5, 1e-2);
    // The line in elevation ran 3° of azimuth beside the source: there its peak is 0.034° higher than the source.
    EXPECT_NEAR(cross->peak.elevation.degrees(), 59.466, 2e-3);
    const auto bad = fitCrossScan({.azimuth = 0_deg, .elevation = 60_deg}, scan({.at = 1.5}, 8.0, 33), {});
    ASSERT_FALSE(bad.has_value());
    EXPECT_THAT(bad.error().text, HasSubstr("in elevation: 0 readings"));
    EXPECT_FALSE(fitCrossScan({.azimuth = 0_deg, .elevation = 90_deg}, scan({}, 8.0, 33), scan({}, 8.0, 33)));
}

}  // namespace
}  // namespace boresight::calibration
