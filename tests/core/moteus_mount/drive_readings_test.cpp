// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/drive_readings.h"

#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

using namespace std::chrono_literals;

constexpr double kLastDigit = 0.1001;  // A, V, °C: the resolution of 16 bits, rounded towards zero

struct Readings : ::testing::Test
{
    [[nodiscard]] DriveReadings azimuth() const { return rig.control.status().drives->azimuth.readings; }
    [[nodiscard]] DriveReadings elevation() const { return rig.control.status().drives->elevation.readings; }

    StationRig rig;
};

// REQ-MOTEUS_MOUNT-900: Every quantity that a drive reports is shown in its unit and under its axis, with the value of
// the last reply. A quantity that is missing in the reply is empty.
TEST_F(Readings, EachQuantityIsTheOneThatTheReplyHas)
{
    rig.azimuth.position = 0.375;
    rig.azimuth.velocity = -0.0125;
    rig.azimuth.torque = 7.25;
    rig.azimuth.current = -3.4;
    rig.azimuth.dCurrent = 0.6;
    rig.azimuth.power = -12.5;
    rig.azimuth.voltage = 24.3;
    rig.azimuth.temperature = 41.7;
    rig.azimuth.motorTemperature = 55.1;
    rig.tick();
    const DriveReadings now = azimuth();
    EXPECT_DOUBLE_EQ(now.motorTurns.value(), 0.375);
    EXPECT_NEAR(now.motorTurnsPerSecond.value(), -0.0125, 1e-9);
    EXPECT_DOUBLE_EQ(now.torque.value(), 7.25);
    EXPECT_NEAR(now.qCurrent.value(), -3.4, kLastDigit);
    EXPECT_NEAR(now.dCurrent.value(), 0.6, kLastDigit);
    EXPECT_NEAR(now.power.value(), -12.5, 1e-9);
    EXPECT_NEAR(now.busVoltage.value(), 24.3, kLastDigit);
    EXPECT_NEAR(now.boardTemperature.value(), 41.7, kLastDigit);
    EXPECT_NEAR(now.motorTemperature.value(), 55.1, kLastDigit);
    EXPECT_DOUBLE_EQ(elevation().motorTurns.value(), -0.25);
    EXPECT_FALSE(elevation().motorTemperature) << "a drive without a sensor reports 0";
    rig.azimuth.modeOnly = true;
    rig.tick();
    EXPECT_FALSE(azimuth().motorTurns || azimuth().torque || azimuth().power) << "not those of the reply before";
    EXPECT_EQ(azimuth().mode, QStringLiteral("stopped (0)"));
}

// REQ-MOTEUS_MOUNT-901: Mode and fault of a drive are shown in words with their numbers. An active limit is not shown
// as a fault.
TEST_F(Readings, ModeAndFaultAreWordsWithTheirNumbers)
{
    rig.tick();
    EXPECT_EQ(azimuth().mode, QStringLiteral("stopped (0)"));
    EXPECT_EQ(azimuth().fault, QStringLiteral("none"));
    rig.azimuth.mode = moteus::Mode::Position;
    rig.azimuth.fault = 100;
    rig.elevation.mode = moteus::Mode::Fault;
    rig.elevation.fault = 38;
    rig.tick();
    EXPECT_EQ(azimuth().mode, QStringLiteral("position (10)"));
    EXPECT_TRUE(azimuth().fault.startsWith(QStringLiteral("limit: "))) << azimuth().fault.toStdString();
    EXPECT_TRUE(azimuth().fault.endsWith(QStringLiteral("(100)"))) << azimuth().fault.toStdString();
    EXPECT_EQ(elevation().mode, QStringLiteral("fault (1)"));
    EXPECT_EQ(elevation().fault, QStringLiteral("over temperature (38)"));
}

// REQ-MOTEUS_MOUNT-902: Readings always show their age. The age of the last reply of a silent drive grows, also while
// the bus is released. A drive that never replied has no readings.
TEST_F(Readings, TheAgeOfASilentDriveGrows)
{
    rig.azimuth.mute = true;
    rig.run(1s);
    EXPECT_FALSE(azimuth().age);
    EXPECT_FALSE(azimuth().motorTurns || azimuth().busVoltage);
    EXPECT_TRUE(azimuth().mode.isEmpty() && azimuth().fault.isEmpty());
    EXPECT_LE(elevation().age.value(), 20ms);
    rig.elevation.mute = true;
    rig.run(3s);
    EXPECT_GE(elevation().age.value(), 2980ms);
    EXPECT_TRUE(elevation().busVoltage);
    ASSERT_TRUE(rig.ask(request::ReleaseBus{}));
    rig.run(2s);
    EXPECT_GE(elevation().age.value(), 4980ms);
}

// REQ-MOTEUS_MOUNT-903: Frames to a drive and its replies are counted from the opening of the line. A frame that is
// still under way does not count as lost.
TEST_F(Readings, FramesAndRepliesAreCounted)
{
    rig.tick();
    for (int tick = 0; tick < 100; ++tick) {
        rig.azimuth.mute = tick % 10 == 0;
        rig.tick();
    }
    rig.tick();
    EXPECT_EQ(azimuth().sent, 101U);
    EXPECT_EQ(azimuth().answered, 91U);
    EXPECT_EQ(elevation().answered, elevation().sent);
    ASSERT_TRUE(rig.ask(request::ReleaseBus{}));
    rig.run(1s);
    EXPECT_LE(azimuth().sent, 102U) << "nothing is sent on a bus that is released";
    rig.mount.lineOpened();
    EXPECT_EQ(rig.control.status().drives->azimuth.readings.sent, 0U);
}

}  // namespace
}  // namespace boresight
