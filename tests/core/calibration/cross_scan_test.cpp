// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/cross_scan.h"

#include "tests/fakes/text_of.h"

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
    double rise = 1000.0;  // power of the source divided by the receiver's own noise
    double noise = 0.0;    // dB
};

// A Gaussian beam across a source, with the receiver's own noise at -100 dB.
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

std::string scanReason(const std::vector<ScanReading>& readings)
{
    const auto peak = fitScan(readings);
    return peak ? "accepted" : textOf(peak.error());
}

// REQ-CALIBRATION-11 (CrossScan.*): The peak of a scan is found on the sphere, with its sigma. Single readings that are
// far off have no effect. A scan without a peak, or with a peak outside, is refused.
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

// In a small dish the Sun only doubles the noise. A parabola fitted in dB made that peak far too wide.
TEST(CrossScan, TakesTheBackgroundAway)
{
    const auto peak = fitScan(scan({.at = 0.8, .rise = 1.0}, 12.0, 49));
    ASSERT_TRUE(peak.has_value());
    EXPECT_NEAR(peak->offset.value.degrees(), 0.8, 1e-3);
    EXPECT_NEAR(peak->halfPowerWidth.degrees(), 10.0, 0.01);
    EXPECT_NEAR(peak->decibels, -96.99, 0.01);
    ASSERT_TRUE(peak->background);
    EXPECT_NEAR(*peak->background, -100.0, 0.01);
    EXPECT_NEAR(decibelsAt(*peak, 5.8_deg), -98.24, 0.01);
    EXPECT_EQ(peak->readings.size(), 49U);
    const auto strong = fitScan(scan({.at = 0.8, .rise = 1e6}, 4.0, 9));
    ASSERT_TRUE(strong.has_value());
    EXPECT_NEAR(decibelsAt(*strong, 5.8_deg), -43.01, 0.05);
}

struct Tries
{
    int found = 0;
    int within = 0;       // within two of the reported sigmas
    double square = 0.0;  // of the error, in beam widths
    [[nodiscard]] double error() const { return std::sqrt(square / found); }
};

// The nine places of the station, with a beam 10° wide and the peak anywhere in the middle half of the line.
Tries tryLines(double rise, double beams, double noise, int count)
{
    Tries tries;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> middleHalf(-0.25, 0.25);
    for (int i = 0; i < count; ++i) {
        const Source source{
            .at = 10.0 * beams * middleHalf(random), .rise = std::pow(10.0, rise / 10.0) - 1.0, .noise = noise};
        if (const auto peak = fitScan(scan(source, 5.0 * beams, 9, static_cast<unsigned>(i + 1)))) {
            const double error = peak->offset.value.degrees() - source.at;
            tries.square += error * error / 100.0;
            tries.within += std::abs(error) < 2.0 * peak->offset.sigma.degrees() ? 1 : 0;
            ++tries.found;
        }
    }
    return tries;
}

// Story: an operator scanned the Sun with the proposed width of three beams, and the result was "no peak". With the two
// beams that the tooltip named, a Sun of 3 dB was never found.
// REQ-CALIBRATION-11a: A Sun of 1 dB above the background is found on 97 of 100 lines that are 1.5 to 3 beams long,
// wherever it lies in their middle half. Noise alone gives a peak on at most 6.
TEST(CrossScan, FindsAWeakSunAtAnyWidthOfTheScan)
{
    constexpr int kTries = 100;
    for (const double rise : {1.0, 3.0, 4.8, 7.0, 10.0, 30.0}) {
        for (const double beams : {1.5, 2.0, 2.5, 3.0}) {
            const Tries tries = tryLines(rise, beams, 0.1, kTries);
            SCOPED_TRACE(testing::Message() << rise << " dB, " << beams << " beams: found " << tries.found);
            EXPECT_GE(tries.found, kTries * 97 / 100);
            EXPECT_LT(tries.error(), rise < 3.0 ? 0.06 : 0.02);
            EXPECT_GE(tries.within, tries.found * 88 / 100);
        }
    }
}

// REQ-CALIBRATION-11a
TEST(CrossScan, NoiseAloneIsNoPeak)
{
    for (const double beams : {1.5, 2.0, 3.0}) {
        EXPECT_LE(tryLines(0.0, beams, 0.1, 300).found, 300 * 6 / 100);
    }
}

// A uniformly illuminated dish: its beam is narrower than a Gaussian farther down, and has side lobes of -17.6 dB.
TEST(CrossScan, ARealBeamIsNoGaussian)
{
    for (const double at : {0.0, 0.2, 0.5}) {
        for (const double reach : {1.0, 1.5}) {
            std::vector<ScanReading> readings;
            for (int i = 0; i < 9; ++i) {
                const double x = -reach + 2.0 * reach * i / 8.0;
                const double u = 3.2327 * std::abs(x - at) + 1e-9;  // half power at half a degree
                const double voltage = 2.0 * std::cyl_bessel_j(1.0, u) / u;
                readings.push_back({Angle::fromDegrees(x), 10.0 * std::log10(1.0 + 9.0 * voltage * voltage)});
            }
            const auto peak = fitScan(readings);
            ASSERT_TRUE(peak.has_value()) << at << " of " << reach << ": " << textOf(peak.error());
            EXPECT_NEAR(peak->offset.value.degrees(), at, 0.03) << reach;
        }
    }
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

// The two lines as a mount measures them, by the true angle between the beam and a source on the sphere.
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
    EXPECT_NEAR(cross->peak.azimuth.degrees(), 116.0, 0.1);  // on the sky this is a quarter of the difference
    EXPECT_NEAR(cross->peak.elevation.degrees(), 76.0, 0.02);
}

// Another transmitter nearby, and a lost reading.
TEST(CrossScan, OneReadingFarOffIsNotThePeak)
{
    auto readings = scan({.at = 1.0, .rise = 1e6, .noise = 0.1}, 8.0, 33);
    readings[5].decibels += 18.0;
    readings[18].decibels -= 15.0;
    const auto peak = fitScan(readings);
    ASSERT_TRUE(peak.has_value()) << textOf(peak.error());
    EXPECT_NEAR(peak->offset.value.degrees(), 1.0, 0.1);
}

TEST(CrossScan, IsRefusedWithTheReason)
{
    EXPECT_EQ(scanReason(scan({}, 6.0, 25)), "accepted");
    EXPECT_THAT(scanReason(scan({.at = 9.0}, 6.0, 25)),
                HasSubstr("Move the middle of the scan by at least +6.0° and scan again."));
    EXPECT_THAT(scanReason(scan({.at = -9.0}, 6.0, 25)),
                HasSubstr("Move the middle of the scan by at least -6.0° and scan again."));
    EXPECT_THAT(scanReason(scan({.rise = 0.0}, 6.0, 25)), HasSubstr("dB along this line"));
    EXPECT_THAT(scanReason(scan({}, 6.0, 5)), HasSubstr("5 readings are not enough."));
    auto lone = scan({.rise = 0.0}, 60.0, 25);
    lone[11].decibels += 10.0;
    lone[12].decibels += 10.0;
    EXPECT_THAT(scanReason(lone), HasSubstr("no peak along this line"));
    auto valley = scan({}, 6.0, 25);
    for (ScanReading& reading : valley) {
        reading.decibels = -reading.decibels;
    }
    EXPECT_NE(scanReason(valley), "accepted");
    valley[2].decibels = std::nan("");
    EXPECT_THAT(scanReason(valley), HasSubstr("not a number"));
    EXPECT_THAT(scanReason({}), HasSubstr("0 readings"));
}

TEST(CrossScan, BothLinesGiveThePlaceOfTheAxes)
{
    const auto cross = fitCrossScan({.azimuth = 370_deg, .elevation = 60_deg}, scan({.at = 1.5, .rise = 1e6}, 8.0, 33),
                                    scan({.at = -0.5, .rise = 1e6}, 8.0, 33));
    ASSERT_TRUE(cross.has_value());
    EXPECT_NEAR(cross->peak.azimuth.degrees(), 370.0 + 1.5 / 0.5, 1e-2);
    // The line in elevation ran 3° of azimuth beside the source. There its peak is 0.034° higher than the source.
    EXPECT_NEAR(cross->peak.elevation.degrees(), 59.466, 2e-3);
    const auto bad = fitCrossScan({.azimuth = 0_deg, .elevation = 60_deg}, scan({.at = 1.5}, 8.0, 33), {});
    ASSERT_FALSE(bad.has_value());
    EXPECT_THAT(textOf(bad.error()), HasSubstr("in elevation: 0 readings"));
    // The line in elevation may have run through the peak of the other line. Then nothing has to be corrected.
    const auto through =
        fitCrossScan({.azimuth = 370_deg, .elevation = 60_deg}, scan({.at = 1.5, .rise = 1e6}, 8.0, 33),
                     scan({.at = -0.5, .rise = 1e6}, 8.0, 33), 1.5_deg);
    ASSERT_TRUE(through.has_value());
    EXPECT_NEAR(through->peak.elevation.degrees(), 59.5, 2e-3);
    EXPECT_FALSE(fitCrossScan({.azimuth = 0_deg, .elevation = 90_deg}, scan({}, 8.0, 33), scan({}, 8.0, 33)));
}

}  // namespace
}  // namespace boresight::calibration
