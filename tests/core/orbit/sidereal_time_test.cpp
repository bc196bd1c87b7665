// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/sidereal_time.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace boresight::orbit;

// The constant term of the expression of 1982: 18h 41m 50.54841s at 2000-01-01 12h.
TEST(SiderealTime, IsThatOf1982)
{
    const double seconds = siderealTime({2451544.5, 0.5}) / (2.0 * std::numbers::pi) * 86400.0;
    EXPECT_NEAR(seconds, 67310.54841, 1e-5);
    EXPECT_GE(siderealTime({2400000.5, 0.0}), 0.0);
}
