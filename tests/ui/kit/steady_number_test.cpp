// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/steady_number.h"

#include "core/units/degrees_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace boresight::ui {
namespace {

std::string azimuthShown(SteadyNumber& number, double degrees)
{
    return azimuthText(Angle::fromDegrees(number.shown(degrees)), 2).toStdString();
}

// Story: a mount at -0.005° alternately showed 359.99° and 0.00°.
// REQ-UI-1004 (SteadyNumber.*): The number of an axis that stands still does not alternate between two values, not even
// at north. The number shown is never wrong by more than three quarters of its last digit.
TEST(SteadyNumber, NoiseOnTheBorderOfTwoDigitsShowsOneNumber)
{
    for (const double border : {-0.005, 0.005, 112.995, 359.995, -90.005}) {
        SteadyNumber number(2, 360.0);
        std::set<std::string> seen;
        for (int i = 0; i < 100; ++i) {
            seen.insert(azimuthShown(number, border + (i % 2 == 0 ? 0.002 : -0.002)));
        }
        EXPECT_EQ(seen.size(), 1U) << border;
    }
}

TEST(SteadyNumber, IsNeverWrongByMoreThanThreeQuartersOfTheLastDigit)
{
    SteadyNumber number(2);
    for (int i = -3000; i <= 3000; ++i) {
        const double measured = i * 0.0007;
        EXPECT_LE(std::abs(number.shown(measured) - measured), 0.0075 + 1e-9);
        EXPECT_NEAR(std::remainder(number.shown(measured), 0.01), 0.0, 1e-9) << "a whole count of the last digit";
    }
}

TEST(SteadyNumber, AWholeTurnIsTheSameAzimuthAndAnotherError)
{
    SteadyNumber azimuth(2, 360.0);
    EXPECT_EQ(azimuthShown(azimuth, 359.998), "0.00°");
    EXPECT_EQ(azimuthShown(azimuth, 359.994), "0.00°");
    EXPECT_EQ(azimuthShown(azimuth, -0.004), "0.00°");
    EXPECT_EQ(azimuthShown(azimuth, 359.991), "359.99°");
    SteadyNumber error(2);
    EXPECT_DOUBLE_EQ(error.shown(0.0), 0.0);
    EXPECT_DOUBLE_EQ(error.shown(360.0), 360.0);
}

TEST(SteadyNumber, WhatIsNoNumberStaysNone)
{
    SteadyNumber number(2);
    EXPECT_TRUE(std::isnan(number.shown(std::nan(""))));
    EXPECT_DOUBLE_EQ(number.shown(1.0), 1.0) << "and does not stick";
}

}  // namespace
}  // namespace boresight::ui
