// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/swing_tally.h"

#include "tests/fakes/swung_mount.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight::calibration {
namespace {

using namespace boresight::literals;
using fakes::SwungMount;

std::vector<SwingSample> swung(AzimuthSense sense = AzimuthSense::Clockwise)
{
    SwungMount mount;
    mount.terms.azimuthOffset = 37.4_deg;
    mount.firstAmplitude = 8.0;
    mount.secondAmplitude = 3.0;
    mount.sense = sense;
    std::mt19937_64 random(5);
    return fakes::swing(mount, random).samples;
}

double worst(const std::vector<SwingDot>& dots)
{
    double largest = 0.0;
    for (const SwingDot& dot : dots) {
        largest = std::max(largest, std::abs(dot.error.degrees()));
    }
    return largest;
}

// REQ-CALIBRATION-04 (SwingTally.*)
TEST(SwingTally, SaysHowManyAndWhy)
{
    auto samples = swung();
    EXPECT_EQ(QString(), SwingTally(samples, {}).whyLeftOut({}));
    samples[3].magnetometerCalibration = 1;
    samples[4].motorCurrent = 7.0;
    samples[5].motorCurrent = 7.0;
    samples[6].axisRate = -9_deg_s;
    const SwingTally tally(samples, {});
    EXPECT_EQ(samples.size(), tally.all());
    EXPECT_EQ(4U, tally.leftOut());
    EXPECT_EQ(2U, tally.of(SampleFate::MotorCurrent));
    EXPECT_EQ(tally.whyLeftOut({}).toStdString(),
              "1 with magnetometer calibration below 2, 2 at a motor current above 5.0 A (sensor.swing_current_a), "
              "1 turning faster than 7.5°/s");
    samples[9].heading = orientation::SensorHeading::folded(samples[9].heading.angle() + 90_deg);
    const auto fit = fitCompassSwing(samples);
    ASSERT_TRUE(fit);
    EXPECT_GE(SwingTally(fit->samples).of(SampleFate::Outlier), 1U);
}

TEST(SwingTally, ManyThatAreLeftOutAreToldWithTheResult)
{
    auto samples = swung();
    const auto hintsOf = [&samples] {
        std::vector<std::string> hints;
        const auto fit = fitCompassSwing(samples);
        for (const QString& hint : fit->hints) {
            hints.push_back(hint.toStdString());
        }
        return hints;
    };
    EXPECT_THAT(hintsOf(), testing::Not(testing::Contains(testing::HasSubstr("were left out"))));
    for (std::size_t i = 0; i < samples.size(); i += 7) {
        samples[i].motorCurrent = 7.0;
    }
    EXPECT_THAT(hintsOf(), testing::Contains(testing::HasSubstr("at a motor current above 5.0 A")));
}

// During the swing the dots lie where the fit will put them, apart from the mean of the deviation.
// REQ-CALIBRATION-04a (SwingDots.*): The readings are shown as they arrive, around the heading that they give so far.
TEST(SwingDots, LieAboutTheTrueHeadingWhicheverWayTheSensorCounts)
{
    for (const AzimuthSense sense : {AzimuthSense::Clockwise, AzimuthSense::CounterClockwise}) {
        const auto samples = swung(sense);
        const auto fit = fitCompassSwing(samples);
        ASSERT_TRUE(fit);
        const auto dots = dotsOf(samples, {}, AzimuthSense::Clockwise, samples.size());
        ASSERT_EQ(samples.size(), dots.size());
        for (std::size_t i = 0; i < dots.size(); ++i) {
            EXPECT_NEAR((dots[i].heading - fit->samples[i].heading).wrapped180().degrees(), 0.0, 1.5);
            EXPECT_NEAR((dots[i].error - fit->samples[i].error).wrapped180().degrees(), 0.0, 1.5);
            EXPECT_EQ(samples[i].turning, dots[i].turning);
        }
        EXPECT_LT(worst(dots), 15.0);
    }
}

TEST(SwingDots, AFewReadingsAreShownAsTheSensorIsSaidToCount)
{
    const auto samples = swung(AzimuthSense::CounterClockwise);
    EXPECT_TRUE(dotsOf({}, {}, AzimuthSense::Clockwise, 400).empty());
    const auto one = dotsOf(std::span(samples).first(1), {}, AzimuthSense::CounterClockwise, 400);
    ASSERT_EQ(1U, one.size());
    EXPECT_NEAR(0.0, one.front().error.degrees(), 1e-9);
}

TEST(SwingDots, AreNeverMoreThanAskedFor)
{
    const auto samples = swung();
    for (const std::size_t most : {std::size_t{1}, std::size_t{7}, std::size_t{100}, samples.size() - 1}) {
        const auto dots = dotsOf(samples, {}, AzimuthSense::Clockwise, most);
        EXPECT_EQ(dots.size(), most);
    }
}

// Story: at 0.5°/s 1400 readings arrive. With the 401st reading every second dot disappeared.
TEST(SwingDots, NoneIsLostWithOneReadingMoreThanAreShown)
{
    const auto whole = swung();
    std::vector<SwingSample> samples;
    while (samples.size() < 1400) {
        samples.push_back(whole[samples.size() % whole.size()]);
        const auto dots = dotsOf(samples, {}, AzimuthSense::Clockwise, 400);
        ASSERT_EQ(std::min(samples.size(), std::size_t{400}), dots.size());
    }
    // The dots are spread evenly over all headings.
    std::vector<double> headings;
    for (const SwingDot& dot : dotsOf(samples, {}, AzimuthSense::Clockwise, 400)) {
        headings.push_back(dot.heading.degrees());
    }
    std::ranges::sort(headings);
    for (std::size_t i = 1; i < headings.size(); ++i) {
        EXPECT_LT(headings[i] - headings[i - 1], 10.0);
    }
}

TEST(SwingDots, AReadingThatIsLeftOutIsSeenToBe)
{
    auto samples = swung();
    samples[3].magnetometerCalibration = 1;
    const auto dots = dotsOf(samples, {}, AzimuthSense::Clockwise, samples.size());
    EXPECT_FALSE(dots[3].isUsed);
    EXPECT_EQ(1, std::ranges::count(dots, false, &SwingDot::isUsed));
}

}  // namespace
}  // namespace boresight::calibration
