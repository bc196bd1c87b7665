// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232/esp32_reply.h"

#include "core/gs232/esp32_command.h"

#include <gtest/gtest.h>

namespace boresight::gs232::esp32 {
namespace {

// REQ-GS232-80: The ESP32 relay controller gets decimals of one digit and a heading of 0…360°, one command a line.
TEST(Esp32Command, AreTheBytesOfTheDialect)
{
    EXPECT_EQ(goTo(Axis::Azimuth, Angle::fromDegrees(123.44)), "AZ 123.4\r");
    EXPECT_EQ(goTo(Axis::Azimuth, -10_deg), "AZ 350.0\r");
    EXPECT_EQ(goTo(Axis::Azimuth, 370_deg), "AZ 10.0\r");
    EXPECT_EQ(goTo(Axis::Elevation, 45_deg), "EL 45.0\r");
    EXPECT_EQ(goTo(Axis::Elevation, -3_deg), "EL -3.0\r");
}

// REQ-GS232-81: The lines of the ESP32 relay controller are read as it writes them. Half a number is never a number.
TEST(Esp32Reply, ItsLinesAreRead)
{
    EXPECT_EQ(parseLine("123.4 45.6"),
              Reply(Place{.azimuth = Angle::fromDegrees(123.4), .elevation = Angle::fromDegrees(45.6)}));
    EXPECT_EQ(parseLine("0.0 -2.5"), Reply(Place{.azimuth = 0_deg, .elevation = Angle::fromDegrees(-2.5)}));
    EXPECT_EQ(parseLine("RPRT 0"), Reply(Code{.accepted = true}));
    EXPECT_EQ(parseLine("RPRT -1"), Reply(Code{.accepted = false}));
    EXPECT_EQ(parseLine("VEAdamESP32v1.0"), Reply(Version{}));
    EXPECT_EQ(parseLine("Ready! Type HELP for list of commands."), Reply(Started{}));
    EXPECT_EQ(parseLine("DEBUG OFF"), Reply(Debugs{.on = false}));
    EXPECT_EQ(parseLine("DEBUG | RawX:33.4 | CalcAZ:123.4 | Calib[S:3 G:2 A:1 M:0]"),
              Reply(Digits{.system = 3, .gyroscope = 2, .accelerometer = 1, .magnetometer = 0}));
    EXPECT_EQ(parseLine("CALIB: SYS=0 GYR=3 ACC=1 MAG=2"),
              Reply(Digits{.system = 0, .gyroscope = 3, .accelerometer = 1, .magnetometer = 2, .blocks = true}));
}

TEST(Esp32Reply, AHalfLineIsUnread)
{
    for (const char* const line :
         {"", "123.4", "123.4 45", "123.4 45.", "123 45.6", "123.4  45.6", "123.4 45.67", "361.0 45.6", "-1.0 45.6",
          "AZ 123.4", "RPRT", "RPRT 0 ", "VEAdam", "DEBUG", "DEBUG | RawX:33.4 | CalcAZ:123.4 | Calib[S:3 G:2 A:1 M:",
          "DEBUG | RawX:33.4 | CalcAZ:123.4 | Calib[S:7 G:2 A:1 M:0]", "CALIB: SYS=0 GYR=3 MAG=2"}) {
        EXPECT_EQ(parseLine(line), Reply(Unread{})) << line;
    }
}

TEST(Esp32Reply, NoLineOfAGs232BoxIsOfAnEsp32)
{
    for (const char* const line : {"+0180+0090", "AZ=180  EL=090", "?>", ">", "C2", "123.4 45.6"}) {
        EXPECT_FALSE(isLineOfEsp32(line)) << line;
    }
    EXPECT_TRUE(isLineOfEsp32("RPRT -1"));
}

}  // namespace
}  // namespace boresight::gs232::esp32
