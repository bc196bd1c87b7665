// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/sunlight.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

using namespace boresight;
using namespace boresight::orbit;

namespace {

constexpr double kUnit = 149597870.7;  // km
const Vector kSun{kUnit, 0.0, 0.0};

// A place behind the Earth and beside the axis of its shadow.
Sunlight behind(double back, double aside)
{
    return sunlight({-back, aside, 0.0}, kSun);
}

}  // namespace

// REQ-ORBIT-23: A satellite in the shadow of the Earth is eclipsed, and at the edge of the shadow it is in half shadow.
// The shadow is a cone.
TEST(SunlightOnASatellite, EndsInTheShadowOfTheEarth)
{
    EXPECT_EQ(sunlight({7000.0, 0.0, 0.0}, kSun), Sunlight::Sunlit);
    EXPECT_EQ(sunlight({0.0, 0.0, 7000.0}, kSun), Sunlight::Sunlit);
    EXPECT_EQ(behind(7000.0, 0.0), Sunlight::Eclipsed);
    EXPECT_EQ(behind(42164.0, 0.0), Sunlight::Eclipsed);
    // 42164 km behind the Earth the cone has a radius of 6378 - 195 km, and the half shadow reaches to 6378 + 198 km.
    EXPECT_EQ(behind(42164.0, 6170.0), Sunlight::Eclipsed);
    EXPECT_EQ(behind(42164.0, 6200.0), Sunlight::HalfShadow);
    EXPECT_EQ(behind(42164.0, 6560.0), Sunlight::HalfShadow);
    EXPECT_EQ(behind(42164.0, 6590.0), Sunlight::Sunlit);
    // The cone ends 1.38 million km behind the Earth.
    EXPECT_EQ(behind(1.37e6, 0.0), Sunlight::Eclipsed);
    EXPECT_EQ(behind(1.40e6, 0.0), Sunlight::HalfShadow);
}

// On 2026-06-21 at noon of Greenwich the Sun is over 23.44° N, close to longitude 0.
// REQ-ORBIT-23
TEST(SunlightOnASatellite, KnowsWhereTheSunIs)
{
    const UtcTime noon = std::chrono::sys_days(std::chrono::year(2026) / 6 / 21) + std::chrono::hours(12);
    for (const Site& site : {Site{}, Site{-33.87_deg, 151.21_deg, 10.0}}) {
        ephemeris::Almanac almanac(site);
        const Vector sun = sunOverGround(almanac, Observer(site), noon);
        const double degrees = 180.0 / std::numbers::pi;
        EXPECT_NEAR(std::asin(sun.z / length(sun)) * degrees, 23.437, 0.005);
        EXPECT_NEAR(std::atan2(sun.y, sun.x) * degrees, 0.47, 0.05);
        EXPECT_NEAR(length(sun) / kUnit, 1.0163, 0.0005);
    }
}
