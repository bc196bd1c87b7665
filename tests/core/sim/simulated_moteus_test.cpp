// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/simulated_moteus.h"

#include "core/base/hex.h"
#include "core/moteus/codec.h"
#include "core/sim/reference_mount.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace boresight::sim {
namespace {

using moteus::Register;
using moteus::Resolution;

class SimulatedMoteusTest : public testing::Test
{
protected:
    static MoteusSettings settings()
    {
        MoteusSettings result{.config = commissionedDrive(Axis::Azimuth),
                              .plant = referenceAxis(Axis::Azimuth).plant,
                              .position = 0.25,
                              .referenced = true,
                              .uptime = 0.0};
        result.config.uuid = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
        return result;
    }
    // The reply to these bytes as hexadecimal text, "none" if there is none.
    std::string ask(std::string_view payload, std::uint32_t id = 0x8001)
    {
        CanFrame frame{.id = id, .extended = true};
        frame.setPayload(*parseHex(payload));
        const auto reply = drive.exchange(frame, 0.0);
        return reply ? toHex(reply->payload()) : "none";
    }
    void run(double seconds)
    {
        for (int i = 0; i < static_cast<int>(seconds * 1000.0); ++i) {
            drive.step(1e-3, {});
        }
    }

    SimulatedMoteus drive{settings()};
};

// REQ-SIM-07 (SimulatedMoteusTest.*): Every readable register answers. A reply shows the state before the command. A
// frame for another UUID has no effect.
TEST_F(SimulatedMoteusTest, EveryReadableRegisterAnswers)
{
    int readable = 0;
    for (std::uint32_t number = 0; number < 0x160; ++number) {
        const auto reg = static_cast<Register>(number);
        const auto frame = moteus::encode({.destination = 1, .query = {{reg, Resolution::Int32}}});
        if (!moteus::isReadable(reg)) {
            continue;
        }
        ASSERT_TRUE(frame) << number;
        const auto reply = drive.exchange(*frame, 0.0);
        ASSERT_TRUE(reply);
        EXPECT_TRUE(moteus::decodeReply(*reply)->errors.empty()) << std::hex << number;
        EXPECT_EQ(moteus::decodeReply(*reply)->values.size(), 1u) << std::hex << number;
        ++readable;
    }
    EXPECT_GT(readable, 80);
}

TEST_F(SimulatedMoteusTest, IdentityWords)
{
    EXPECT_EQ(ask("19d002"), "29d00201020304");
    EXPECT_EQ(ask("198202"), "29820205000000") << "register map version 5";
    EXPECT_EQ(ask("198102"), "29810200010100") << "firmware 1.1.0";
}

// Command registers start with the defaults of the drive and show what was written. The state in the reply is still the
// one before.
TEST_F(SimulatedMoteusTest, CommandRegistersReadBack)
{
    EXPECT_EQ(ask("1d25"), "2d250000c842") << "maximum torque 100 Nm";
    EXPECT_EQ(ask("01000a0d200000003f11001d20"), "2100002d200000003f505050");
    EXPECT_EQ(ask("01000a1d20"), "2d2000000000") << "writing the mode clears the position to 0, not to NaN";
}

TEST_F(SimulatedMoteusTest, MaskedFrameOfAnotherDeviceLeavesNoTrace)
{
    // Brake, then a UUID mask that does not match: the frame has no effect, and there is no reply.
    EXPECT_EQ(ask("01000f09d402ffffffff1100"), "none");
    run(0.1);
    EXPECT_EQ(drive.servo().mode(), moteus::Mode::Stopped);
    EXPECT_EQ(ask("09d4020102030401000f1100"), "210000");
    run(0.1);
    EXPECT_EQ(drive.servo().mode(), moteus::Mode::Brake);
}

TEST_F(SimulatedMoteusTest, SixteenIsNoMode)
{
    EXPECT_EQ(ask("0100101100"), "300001210000");
    run(0.05);
    EXPECT_EQ(drive.servo().mode(), moteus::Mode::Stopped);
}

TEST_F(SimulatedMoteusTest, AFrameWithoutModeIsNoCommandAndFeedsNoWatchdog)
{
    ask("01000a0d200000803e");  // position 0.25
    run(0.05);
    EXPECT_EQ(drive.servo().mode(), moteus::Mode::Position);
    for (int i = 0; i < 10; ++i) {
        ask("0d200000003f11001f01");  // position 0.5 without a mode, and a query
        run(0.02);
    }
    EXPECT_EQ(drive.servo().mode(), moteus::Mode::PositionTimeout);
    EXPECT_NEAR(drive.plant().position(), 0.25, 1e-3);
}

TEST_F(SimulatedMoteusTest, PrefixAndBroadcast)
{
    EXPECT_EQ(ask("1100", 0x807f), "210000");
    EXPECT_EQ(ask("1100", 0x18001), "none") << "another prefix";
    EXPECT_EQ(ask("1100", 0x8002), "none");
}

TEST_F(SimulatedMoteusTest, TunnelWithFlowControl)
{
    EXPECT_EQ(ask("40010f636f6e66206765742069642e69640a50", 0x1), "none");  // "conf get id.id\n"
    const std::string first = ask("44010030");
    EXPECT_TRUE(first.starts_with("430101")) << first;
    EXPECT_EQ(ask("44010030"), first) << "not acknowledged: the same packet again";
    EXPECT_EQ(ask("44010130"), "43010200") << "acknowledged and empty";
}

TEST_F(SimulatedMoteusTest, MillisecondCounterOverflowsAfterFiveMinutes)
{
    EXPECT_NEAR(drive.readRegister(Register::MillisecondCounter), 2147483648.0 - 300000.0, 1.0);
    run(300.1);
    EXPECT_LT(drive.readRegister(Register::MillisecondCounter), 0.0);
}

TEST_F(SimulatedMoteusTest, EncoderNoiseIsAboutOneCountAndCanBeSwitchedOff)
{
    double least = 1.0;
    double most = 0.0;
    for (int i = 0; i < 1000; ++i) {
        run(0.001);
        const double raw = drive.readRegister(Register::Encoder0Position);
        const double around = raw > 0.5 ? raw - 1.0 : raw;
        least = std::min(least, around);
        most = std::max(most, around);
    }
    EXPECT_NEAR((most - least) * 16384.0, 2.0, 1.01);

    MoteusSettings quiet = settings();
    quiet.noise.enabled = false;
    SimulatedMoteus silent(quiet);
    silent.step(1e-3, {});
    EXPECT_EQ(silent.readRegister(Register::Velocity), 0.0);
}

// Gains are per turn of the output. A board with factory settings counts turns of the motor.
TEST_F(SimulatedMoteusTest, FactoryBoardCountsRotorTurns)
{
    MoteusSettings factory{.plant = referenceAxis(Axis::Azimuth).plant, .position = 0.2537};
    SimulatedMoteus fresh(factory);
    EXPECT_EQ(fresh.readRegister(Register::HomeState), 1.0);
    EXPECT_NEAR(fresh.reportedPosition(), 25.37 - 25.0, 1e-3);
    CanFrame move{.id = 0x8001, .extended = true};
    move.setPayload(*parseHex("01000a0d20000000003f1100"));
    (void)fresh.exchange(move, 0.0);
    for (int i = 0; i < 50; ++i) {
        fresh.step(1e-3, {});
    }
    EXPECT_EQ(fresh.servo().faultCode(), 39) << "outside the factory's bounds of 0.01";
}

// Hard work against a blocked gear heats the board, first to derating, then to the fault.
// REQ-SIM-06
TEST_F(SimulatedMoteusTest, OverloadHeatsTheBoard)
{
    drive.plant().setStalled(true);
    for (int i = 0; i < 6000; ++i) {
        ask("01000a0e20713d8a3e00000000");  // 7.2° away, 50 Hz: the drive gives up at 10°
        run(0.02);
        if (drive.servo().faultCode() == static_cast<int>(ActiveLimit::FetTemperature)) {
            break;
        }
    }
    EXPECT_EQ(drive.servo().faultCode(), static_cast<int>(ActiveLimit::FetTemperature));
    EXPECT_GT(drive.readRegister(Register::Temperature), 50.0);
}

// Whatever is written into its configuration or sent to it: the drive keeps replying, and the state of the axis stays
// valid.
TEST_F(SimulatedMoteusTest, SurvivesAnyConfigurationAndAnyBytes)
{
    std::minstd_rand random(7);
    const auto pick = [&](std::size_t count) { return static_cast<std::size_t>(random()) % count; };
    std::vector<std::string> keys;
    DriveConfig listed;
    visitFields(listed, [&](std::string_view key, const ConfigField&) {
        if (!key.starts_with("can.")) {  // a drive with another CAN prefix does not receive us any more
            keys.emplace_back(key);
        }
    });
    const std::array<const char*, 10> values{"0",     "-1", "nan", "1e30", "-1e30",
                                             "1e-30", "12", "0.3", "x",    "4294967296"};
    for (int round = 0; round < 3000; ++round) {
        const std::string line = "conf set " + keys[pick(keys.size())] + " " + values[pick(values.size())] + "\n";
        drive.receiveText(1, {reinterpret_cast<const std::uint8_t*>(line.data()), line.size()});
        drive.dropText(1, drive.pendingText(1).size());
        CanFrame frame{.id = 0x807f, .extended = true};
        frame.size = kMaxCanPayload;
        for (std::uint8_t& byte : frame.data) {
            byte = static_cast<std::uint8_t>(random());
        }
        (void)drive.exchange(frame, 0.0);
        ask("0100000b207f80ff", 0x7f);
        run(0.003);
        ask(pick(2) == 0 ? "01000a" : "01000a0e207fc00000cdcccc3d", 0x7f);
        run(0.02);
        ASSERT_TRUE(std::isfinite(drive.plant().position())) << line;
        ASSERT_TRUE(std::isfinite(drive.plant().loadPosition())) << line;
        ASSERT_TRUE(std::isfinite(drive.supplyPower())) << line;
    }
}

}  // namespace
}  // namespace boresight::sim
