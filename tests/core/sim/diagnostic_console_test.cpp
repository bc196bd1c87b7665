// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/codec.h"
#include "core/moteus/count_origin.h"
#include "core/sim/reference_mount.h"
#include "core/sim/simulated_moteus.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace boresight::sim {
namespace {

using moteus::Mode;

// One drive by its console, without the tunnel of the bus.
class DiagnosticConsoleTest : public testing::Test
{
protected:
    static MoteusSettings settings()
    {
        MoteusSettings result{.config = commissionedDrive(Axis::Azimuth),
                              .plant = referenceAxis(Axis::Azimuth).plant,
                              .position = 0.25,
                              .referenced = true,
                              .noise = {.enabled = false}};
        result.config.uuid = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
        return result;
    }
    std::string say(const std::string& line)
    {
        const std::string bytes = line + "\n";
        drive.receiveText(1, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
        return pending();
    }
    std::string pending()
    {
        const auto text = drive.pendingText(1);
        const std::string result(text.begin(), text.end());
        drive.dropText(1, text.size());
        return result;
    }
    void run(double seconds)
    {
        for (int i = 0; i < static_cast<int>(seconds * 1000.0); ++i) {
            drive.step(1e-3, {});
        }
    }
    double read(moteus::Register reg) { return drive.readRegister(reg); }

    SimulatedMoteus drive{settings()};
};

// REQ-SIM-08 (DiagnosticConsoleTest.*): The console has `conf`, `tel` and `d` with binary schemas. Written
// configuration survives a power cycle.
TEST_F(DiagnosticConsoleTest, ConfigurationIsReadAndSet)
{
    EXPECT_EQ(say("conf get servo.default_timeout_s"), "0.100000\r\n") << "the value alone, no OK";
    EXPECT_EQ(say("conf get servo.max_power_W"), "nan\r\n");
    EXPECT_EQ(say("conf get id.id"), "1\r\n");
    EXPECT_EQ(say("conf set servo.default_timeout_s 0.25"), "OK\r\n");
    EXPECT_EQ(say("conf get servo.default_timeout_s"), "0.250000\r\n");
    EXPECT_EQ(say("conf set servo.max_current_A rubbish"), "OK\r\n") << "as the device does";
    EXPECT_EQ(say("conf get servo.max_current_A"), "0.000000\r\n");
}

TEST_F(DiagnosticConsoleTest, RefusesInTheDevicesWords)
{
    EXPECT_EQ(say("conf get nothing.there"), "ERR unknown group\r\n");
    EXPECT_EQ(say("conf get servo.nothing"), "ERR error reading\r\n");
    EXPECT_EQ(say("conf set servo.nothing 1"), "ERR error setting\r\n");
    EXPECT_EQ(say("conf dance"), "ERR unknown subcommand\r\n");
    EXPECT_EQ(say("tel get nothing"), "ERR unknown name\r\n");
    EXPECT_EQ(say("d dance"), "ERR unknown command\r\n");
    EXPECT_EQ(say("d pos 1 2"), "ERR missing p/v/i\r\n");
    EXPECT_EQ(say("d pos 1 2 3 x4"), "ERR unknown option\r\n");
    EXPECT_EQ(say("dance"), "ERR unknown command\r\n");
    EXPECT_EQ(say(std::string(101, 'x')), "") << "longer than the device's line";
}

TEST_F(DiagnosticConsoleTest, EnumerateListsEverything)
{
    const std::string uuid = say("conf enumerate uuid");
    EXPECT_TRUE(uuid.starts_with("uuid.uuid.0 1\r\n"));
    EXPECT_TRUE(uuid.ends_with("uuid.uuid.15 16\r\nOK\r\n"));
    const std::string all = say("conf enumerate");
    for (const char* key : {"id.id 1", "servopos.position_max 1.258333", "servo.timeout_mode 10",
                            "motor_position.rotor_to_output_ratio 0.010000"}) {
        EXPECT_NE(all.find(std::string(key) + "\r\n"), std::string::npos) << key;
    }
    EXPECT_EQ(say("conf list"),
              "id\r\ncan\r\nuuid\r\nservo\r\nservopos\r\nmotor\r\nmotor_position\r\naux1\r\naux2\r\nOK\r\n");
}

// Object, flags 0; field "id": flags 0, name, 0 aliases, int of 4 bytes, no default; end.
TEST_F(DiagnosticConsoleTest, BinaryConfigurationOfOneGroup)
{
    const std::string_view schema("\x10\x00\x00\x02id\x00\x03\x04\x00\x00\x00\x00\x00\x00", 15);
    EXPECT_EQ(say("conf schema id"), std::string("cschema id\r\n\x0f\x00\x00\x00", 16).append(schema));
    EXPECT_EQ(say("conf data id"), std::string("cdata id\r\n\x04\x00\x00\x00\x01\x00\x00\x00", 18));
    EXPECT_EQ(say("conf schema nothing"), "ERR unknown group\r\n");
}

TEST_F(DiagnosticConsoleTest, WrittenConfigurationSurvivesThePowerCycle)
{
    say("conf set servo.max_current_A 12");
    say("conf write");
    say("conf set servo.max_current_A 7");
    say("conf set id.id 9");
    drive.setPowered(false);
    drive.setPowered(true);
    EXPECT_EQ(say("conf get servo.max_current_A"), "12.000000\r\n");
    EXPECT_EQ(say("conf get id.id"), "1\r\n");
    say("conf default");
    EXPECT_EQ(say("conf get servopos.position_max"), "0.010000\r\n");
    say("conf load");
    EXPECT_EQ(say("conf get servo.max_current_A"), "12.000000\r\n");
}

TEST_F(DiagnosticConsoleTest, IdChangesAtOnce)
{
    say("conf set id.id 30");
    const auto frame = moteus::encode({.destination = 30, .query = moteus::basicQuery()});
    ASSERT_TRUE(frame);
    EXPECT_TRUE(drive.exchange(*frame, 0.0));
    say("conf set id.id 200");
    EXPECT_EQ(say("conf get id.id"), "1\r\n") << "what is no address becomes 1";
}

TEST_F(DiagnosticConsoleTest, TelemetryInBinaryAndText)
{
    EXPECT_EQ(say("tel list"), "firmware\r\ngit\r\nservo_stats\r\nmotor_position\r\nOK\r\n");
    EXPECT_EQ(say("tel stop"), "OK\r\n");
    const std::string firmware = say("tel get firmware");
    ASSERT_EQ(firmware.size(), std::strlen("emit firmware\r\n") + 4 + 22);
    EXPECT_EQ(firmware.substr(19, 4), std::string("\x00\x01\x01\x00", 4)) << "1.1.0";
    EXPECT_EQ(firmware.back(), 8) << "r4.11";
    EXPECT_EQ(say("tel fmt servo_stats 1"), "OK\r\n");
    run(0.001);
    const std::string encoders = say("tel get motor_position");
    ASSERT_EQ(encoders.size(), std::strlen("emit motor_position\r\n") + 4 + 1 + 3 * 53 + 45);
    EXPECT_TRUE(moteus::countOrigin(encoders.substr(25)));
    const std::string text = say("tel get servo_stats");
    EXPECT_TRUE(text.starts_with("servo_stats.mode 0\r\nservo_stats.fault 0\r\nservo_stats.bus_V 24.000000\r\n"))
        << text;
    EXPECT_NE(text.find("servo_stats.position 0.25"), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("OK\r\n"));
}

TEST_F(DiagnosticConsoleTest, PeriodicTelemetryUntilStopped)
{
    say("tel fmt git 1");
    EXPECT_EQ(say("tel rate git 100"), "OK\r\n");
    run(1.05);
    std::string text = pending();
    int emitted = 0;
    for (std::size_t at = text.find("git.dirty"); at != std::string::npos; at = text.find("git.dirty", at + 1)) {
        ++emitted;
    }
    EXPECT_EQ(emitted, 10);
    say("tel stop");
    run(1.0);
    EXPECT_EQ(pending(), "");
}

TEST_F(DiagnosticConsoleTest, MovesAndStops)
{
    EXPECT_EQ(say("d pos nan 0.02 50 a0.1 v0.05"), "OK\r\n");
    run(3.0);
    EXPECT_EQ(drive.servo().mode(), Mode::Position) << "no watchdog unless asked";
    EXPECT_NEAR(drive.plant().velocity(), 0.02, 1e-3);
    EXPECT_EQ(say("d brake"), "OK\r\n");
    run(0.01);
    EXPECT_EQ(drive.servo().mode(), Mode::Brake);
    EXPECT_EQ(say("d pos nan 0 nan t0.2"), "OK\r\n");
    run(0.5);
    EXPECT_EQ(drive.servo().mode(), Mode::PositionTimeout);
    EXPECT_EQ(say("d stop"), "OK\r\n");
    run(0.01);
    EXPECT_EQ(say("d within -1 1 10"), "OK\r\n");
    run(0.05);
    EXPECT_EQ(drive.servo().mode(), Mode::StayWithin);
    EXPECT_EQ(say("d zero"), "OK\r\n");
    run(0.01);
    EXPECT_EQ(drive.servo().mode(), Mode::ZeroVelocity);
}

TEST_F(DiagnosticConsoleTest, OutputPositionIsSet)
{
    EXPECT_EQ(say("d exact 0.4"), "OK\r\n");
    EXPECT_NEAR(read(moteus::Register::Position), 0.4, 2e-5);
    EXPECT_EQ(say("d nearest 0.1"), "OK\r\n");
    EXPECT_NEAR(read(moteus::Register::Position), 0.1, 0.005) << "a whole rotor turn is 0.01";
    EXPECT_EQ(say("d cfg-set-output 0.3"), "OK\r\n");
    EXPECT_NEAR(read(moteus::Register::Position), 0.3, 2e-5);
    EXPECT_EQ(say("d req-reindex"), "OK\r\n");
    EXPECT_EQ(read(moteus::Register::HomeState), 0.0);
}

TEST_F(DiagnosticConsoleTest, SettingTheOutputMovesNothing)
{
    say("d pos nan 0 nan");
    run(0.5);
    const double before = drive.plant().position();
    say("d exact 0.9");
    run(1.0);
    EXPECT_NEAR(drive.plant().position(), before, 1e-5);
    EXPECT_NEAR(read(moteus::Register::ControlPosition), 0.9, 1e-4);
}

TEST_F(DiagnosticConsoleTest, EncoderSettingsUnderARunningServoFault)
{
    say("d pos nan 0 nan");
    run(0.1);
    say("conf set motor_position.output.sign -1");
    run(0.01);
    EXPECT_EQ(drive.servo().mode(), Mode::Fault);
    EXPECT_EQ(drive.servo().faultCode(), 41);
}

}  // namespace
}  // namespace boresight::sim
