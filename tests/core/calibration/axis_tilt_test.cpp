// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/axis_tilt.h"

#include "core/calibration/fit_words.h"
#include "tests/fakes/swung_mount.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace boresight::calibration {
namespace {

using fakes::SwungMount;
using ::testing::HasSubstr;

SwungMount leaning()
{
    SwungMount mount;
    mount.terms.azimuthOffset = 37.4_deg;
    mount.terms.tiltNorth = 0.6_deg * std::cos((120_deg).radians());
    mount.terms.tiltEast = 0.6_deg * std::sin((120_deg).radians());
    return mount;
}

std::vector<LevelSample> levels(const SwungMount& mount, const fakes::SwingPlan& plan = {})
{
    std::mt19937_64 random(11);
    return fakes::swing(mount, random, plan).levels;
}

std::string reason(const std::vector<LevelSample>& samples)
{
    const auto tilt = fitAxisTilt(samples, {});
    return tilt ? "accepted" : textOf(tilt.error());
}

// REQ-CALIBRATION-10 (AxisTilt.*): The measured elevations over one turn give the size and direction of the tilt, and
// the zero of elevation.
TEST(AxisTilt, IsFoundWithItsDirection)
{
    const auto tilt = fitAxisTilt(levels(leaning()), {37.4_deg, 1_deg});
    ASSERT_TRUE(tilt.has_value());
    EXPECT_NEAR(tilt->size.degrees(), 0.6, 0.05);
    EXPECT_NEAR(tilt->direction.degrees(), 120.0, 5.0);
    EXPECT_NEAR(tilt->north.value.degrees(), leaning().terms.tiltNorth.degrees(), 0.05);
    EXPECT_NEAR(tilt->east.value.degrees(), leaning().terms.tiltEast.degrees(), 0.05);
    EXPECT_LT(tilt->sizeSigma, 0.1_deg);
    EXPECT_NEAR(tilt->elevationOffset.value.degrees(), 0.0, 0.05);
}

TEST(AxisTilt, AnErrorOfTheAccelerometerSpoilsTheZeroOnly)
{
    SwungMount mount = leaning();
    mount.gravityBias = 0.1;  // m/s²: 1.2° at 30° of elevation
    const auto tilt = fitAxisTilt(levels(mount), {37.4_deg, 1_deg});
    ASSERT_TRUE(tilt.has_value());
    EXPECT_NEAR(tilt->size.degrees(), 0.6, 0.06);
    EXPECT_GT(abs(tilt->elevationOffset.value), 0.8_deg);
    EXPECT_GT(tilt->elevationOffset.sigma, 0.9_deg);
}

TEST(AxisTilt, TheSigmaIsHonestForRandomMounts)
{
    std::mt19937_64 random(7);
    constexpr int kMounts = 100;
    int honest = 0;
    for (int i = 0; i < kMounts; ++i) {
        const SwungMount mount = fakes::randomMount(random, fakes::Needle::Harmonics);
        const auto tilt = fitAxisTilt(fakes::swing(mount, random).levels, {mount.terms.azimuthOffset, 1_deg});
        ASSERT_TRUE(tilt.has_value());
        honest += abs(tilt->north.value - mount.terms.tiltNorth) < tilt->north.sigma * 2.0 ? 1 : 0;
        honest += abs(tilt->east.value - mount.terms.tiltEast) < tilt->east.sigma * 2.0 ? 1 : 0;
        EXPECT_LT(tilt->sizeSigma, 0.15_deg);
    }
    EXPECT_GE(honest, 2 * kMounts * 94 / 100);
}

// With the boom at 70° a roll r of the box turns the direction of the tilt by r / sin(elevation), that is by nearly r,
// and not by r / tan(elevation).
TEST(AxisTilt, TheSigmaIsHonestWithTheBoomHigh)
{
    SwungMount mount = leaning();
    mount.roll = 3.0;
    const auto tilt = fitAxisTilt(levels(mount, {.elevation = 70.0}), {37.4_deg, 0.01_deg});
    ASSERT_TRUE(tilt.has_value());
    const double turned = 0.6 * std::sin((3_deg).radians()) / std::sin((70_deg).radians());
    EXPECT_GE(hypot(tilt->north.sigma, tilt->east.sigma).degrees(), turned);
    EXPECT_LT(abs(tilt->north.value - mount.terms.tiltNorth), tilt->north.sigma * 2.0);
    EXPECT_LT(abs(tilt->east.value - mount.terms.tiltEast), tilt->east.sigma * 2.0);
}

TEST(AxisTilt, LeavesOutAGust)
{
    auto samples = levels(leaning());
    samples[40].elevation += 4_deg;
    const auto tilt = fitAxisTilt(samples, {37.4_deg, 1_deg});
    ASSERT_TRUE(tilt.has_value());
    EXPECT_THAT(tilt->rejected, ::testing::Contains(40U));
    EXPECT_NEAR(tilt->size.degrees(), 0.6, 0.05);
}

TEST(AxisTilt, IsRefusedWithTheReason)
{
    EXPECT_THAT(reason(levels(leaning(), {.elevation = 5.0})), HasSubstr("the boom between 10° and 80°"));
    EXPECT_THAT(reason(levels(leaning(), {.from = 0.0, .to = 100.0})),
                HasSubstr("The tilt needs readings over at least 120° of azimuth."));
    EXPECT_THAT(reason({}), HasSubstr("The tilt needs readings over at least 120° of azimuth."));
    auto few = levels(leaning());
    few.erase(few.begin() + 4, few.end());
    few[3].axisAzimuth = 200_deg;
    EXPECT_THAT(reason(few), HasSubstr("4 readings are not enough for the tilt."));
    // Many readings, but only at two azimuths.
    auto two = levels(leaning());
    for (std::size_t i = 0; i < two.size(); ++i) {
        two[i].axisAzimuth = i % 2 == 0 ? 0_deg : 150_deg;
    }
    EXPECT_THAT(reason(two), HasSubstr("do not determine the tilt. Take readings at more azimuths"));
    few[2].elevation = Angle::fromDegrees(std::nan(""));
    EXPECT_THAT(reason(few), HasSubstr("not a number"));
}

}  // namespace
}  // namespace boresight::calibration
