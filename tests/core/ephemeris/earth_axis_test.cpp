// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/earth_axis.h"

#include "core/ephemeris/time_scales.h"

#include <gtest/gtest.h>

#include <chrono>

namespace boresight::ephemeris {
namespace {

using namespace std::chrono_literals;

// Example 3-14 of Vallado, Fundamentals of Astrodynamics and Applications, in km: a position in the GCRF, and the same
// position in the frame of the Earth before polar motion. The example has UT1 = UTC - 0.4399619 s. Here UT1 equals UTC,
// so the time is earlier by this amount.
const UtcTime kVallado =
    std::chrono::sys_days(std::chrono::year(2004) / 4 / 6) + 7h + 51min + 27s + std::chrono::microseconds(946'047);
constexpr EarthAxis::Vector kGcrf{5102.508958, 6123.011401, 6378.136928};
constexpr EarthAxis::Vector kTurned{-1033.4750313, 7901.3055856, 6380.3445328};

// REQ-EPHEMERIS-950: A position in the celestial frame is converted to the frame of the Earth as in a published
// example, to 2 m in 10,000 km.
TEST(EarthAxis, MeetsThePublishedExample)
{
    EarthAxis axis;
    const EarthAxis::Vector turned = axis.ofTheEarth(kGcrf, kVallado);
    for (std::size_t i = 0; i < turned.size(); ++i) {
        EXPECT_NEAR(turned[i], kTurned[i], 0.002) << i;
    }
}

// REQ-EPHEMERIS-950
TEST(EarthAxis, WhatIsRememberedChangesNoAnswer)
{
    EarthAxis axis;
    (void)axis.ofTheEarth(kGcrf, kVallado - 10min);
    (void)axis.ofTheEarthFromDate(kGcrf, kVallado + 1h);
    EXPECT_EQ(axis.ofTheEarth(kGcrf, kVallado), EarthAxis().ofTheEarth(kGcrf, kVallado));
}

// REQ-EPHEMERIS-951: The leap seconds are those of the IERS.
TEST(TimeScales, KnowTheLeapSeconds)
{
    const auto of = [](int year, unsigned month, unsigned day) {
        return leapSeconds(std::chrono::year(year) / std::chrono::month(month) / std::chrono::day(day)).count();
    };
    EXPECT_EQ(of(1972, 1, 1), 10.0);
    EXPECT_EQ(of(2016, 12, 31), 36.0);
    EXPECT_EQ(of(2017, 1, 1), 37.0);
    EXPECT_EQ(of(2026, 11, 27), 37.0);
    EXPECT_EQ(of(1957, 10, 4), 0.0);
}

}  // namespace
}  // namespace boresight::ephemeris
