// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232/box_command.h"

#include <gtest/gtest.h>

#include <limits>

namespace boresight::gs232 {
namespace {

AxisPosition at(double azimuth, double elevation)
{
    return {.azimuth = Angle::fromDegrees(azimuth), .elevation = Angle::fromDegrees(elevation)};
}

// REQ-GS232-01: Commands are the bytes that Hamlib's GS-232A driver writes: whole degrees with three digits, and one
// CR.
TEST(BoxCommand, AreTheBytesOfTheRecordings)
{
    EXPECT_EQ(goTo(at(123.4, 45.6)), "W123 046\r");
    EXPECT_EQ(goTo(at(359.6, 0.4)), "W360 000\r");
    EXPECT_EQ(goTo(at(400.0, 30.0)), "W400 030\r");
    EXPECT_EQ(goToAzimuth(7_deg), "M007\r");
    EXPECT_EQ(kAskBoth, "C2\r");
    EXPECT_EQ(kStopAll, "S\r");
}

// REQ-GS232-02: A position outside the range of the control box is never sent, and never clipped.
TEST(BoxCommand, APlaceOutsideIsNoCommand)
{
    EXPECT_EQ(goTo(at(450.0, 180.0)), "W450 180\r");
    EXPECT_EQ(goTo(at(0.0, 0.0)), "W000 000\r");
    EXPECT_FALSE(goTo(at(450.6, 10.0)));
    EXPECT_FALSE(goTo(at(-0.6, 10.0)));
    EXPECT_FALSE(goTo(at(10.0, 181.0)));
    EXPECT_FALSE(goTo(at(10.0, -1.0)));
    EXPECT_FALSE(goTo(at(std::numeric_limits<double>::quiet_NaN(), 10.0)));
    EXPECT_FALSE(goToAzimuth(451_deg));
}

TEST(BoxCommand, KnowsItsOwn)
{
    for (const char* const own : {"C2", "C", "S", "W123 046", "M007"}) {
        EXPECT_TRUE(isOwnCommand(own)) << own;
    }
    for (const char* const other : {"", "C3", "W123 04", "W123 0466", "W12 3046", "AZ=180", "+0180+0090", "s"}) {
        EXPECT_FALSE(isOwnCommand(other)) << other;
    }
}

}  // namespace
}  // namespace boresight::gs232
