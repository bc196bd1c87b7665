// SPDX-License-Identifier: GPL-3.0-or-later
// A drive with a console that behaves unlike the simulated one: unknown keys, and settings that are not kept.
#include "core/drive_check/axis_check.h"

#include "core/moteus/frame_server.h"

#include <gmock/gmock.h>

#include <map>

namespace boresight::drive_check {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class OddDrive final : public moteus::ServedDevice
{
public:
    [[nodiscard]] double readRegister(moteus::Register) override { return 0.0; }
    [[nodiscard]] std::uint32_t writeRegister(moteus::Register, double) override { return 0; }
    void completeFrame(FrameEnd) override {}
    [[nodiscard]] bool hasChannel(std::uint32_t channel) override { return channel == moteus::kDiagnosticChannel; }
    void receiveText(std::uint32_t, std::span<const std::uint8_t> text) override
    {
        for (const std::uint8_t byte : text) {
            if (byte == '\n') {
                answer(std::exchange(m_input, {}));
            } else {
                m_input.push_back(static_cast<char>(byte));
            }
        }
    }
    [[nodiscard]] std::span<const std::uint8_t> pendingText(std::uint32_t) override { return m_output; }
    void dropText(std::uint32_t, std::size_t count) override
    {
        m_output.erase(m_output.begin(), m_output.begin() + static_cast<std::ptrdiff_t>(count));
    }

    std::map<std::string, std::string> settings;
    std::string garbled;  // a key whose new value always arrives garbled
    bool canStore = true;
    std::vector<std::string> heard;

private:
    void answer(const std::string& line)
    {
        heard.push_back(line);
        if (line.starts_with("conf get ")) {
            const auto found = settings.find(line.substr(9));
            return say(found != settings.end() ? found->second : "ERR error reading");
        }
        if (line.starts_with("conf set ")) {
            const std::string key = line.substr(9, line.find(' ', 9) - 9);
            settings[key] = key == garbled ? "0.000000" : line.substr(10 + key.size());
        }
        say(line == "conf write" && !canStore ? "ERR flash" : "OK");
    }
    void say(const std::string& line)
    {
        m_output.insert(m_output.end(), line.begin(), line.end());
        m_output.push_back('\n');
    }

    std::string m_input;
    std::vector<std::uint8_t> m_output;
};

class AxisCheckTest : public testing::Test
{
protected:
    AxisCheckTest()
    {
        for (const Protection& one : protectionsOf({}, Axis::Azimuth)) {
            drive.settings[one.key] = one.remedy ? settingText(*one.remedy) : "1";
        }
        drive.settings["motor_position.rotor_to_output_ratio"] = "0.010000";
    }
    void runUntilIdle()
    {
        for (int i = 0; i < 1000 && driveCheck.isBusy(); ++i) {
            now += std::chrono::milliseconds(20);
            const auto frame = driveCheck.frame(now);
            const auto reply = frame ? server.serve(*frame, {.id = 1}, drive) : std::nullopt;
            if (reply) {
                driveCheck.take(*moteus::decodeReply(*reply));
            }
        }
    }
    void read()
    {
        driveCheck.read({1, 2, 3, 4});
        runUntilIdle();
        ASSERT_TRUE(driveCheck.isComplete()) << driveCheck.trouble().toStdString();
    }
    ProtectionLine line(const char* key)
    {
        const auto found = std::ranges::find(driveCheck.lines(), QLatin1String(key), &ProtectionLine::key);
        return found != driveCheck.lines().end() ? *found : ProtectionLine{};
    }

    SteadyTime now{std::chrono::hours(1)};
    OddDrive drive;
    moteus::FrameServer server;
    AxisCheck driveCheck{{}, Axis::Azimuth};
};

TEST_F(AxisCheckTest, AKeyThatTheFirmwareDoesNotKnowIsSaidAndNotWritten)
{
    drive.settings.erase("servo.fault_position_error");
    read();
    EXPECT_EQ(line("servo.fault_position_error").verdict, Verdict::Advised);
    EXPECT_EQ(line("servo.fault_position_error").found, QStringLiteral("not known to this firmware"));
    EXPECT_FALSE(driveCheck.isFixable());
    EXPECT_FALSE(driveCheck.value("servo.fault_position_error"));
}

TEST_F(AxisCheckTest, NothingIsStoredIfOneSettingDoesNotReadBack)
{
    drive.settings["servo.timeout_mode"] = "12";
    drive.settings["servopos.position_max"] = "0.010000";
    drive.garbled = "servopos.position_max";
    read();
    driveCheck.fix();
    runUntilIdle();
    EXPECT_THAT(drive.heard, Not(Contains("conf write")));
    EXPECT_THAT(driveCheck.fixTrouble().toStdString(),
                HasSubstr("servopos.position_max was set to 1.258333 and reads back 0 turns"));
    EXPECT_TRUE(driveCheck.isComplete());
    EXPECT_EQ(line("servopos.position_max").verdict, Verdict::Dangerous) << "as it is now, not as it was told";
    EXPECT_TRUE(driveCheck.isFixable());
}

TEST_F(AxisCheckTest, ARefusedStoringIsSaid)
{
    drive.settings["servo.timeout_mode"] = "12";
    drive.canStore = false;
    read();
    driveCheck.fix();
    runUntilIdle();
    EXPECT_THAT(driveCheck.fixTrouble().toStdString(), HasSubstr("azimuth did not store its settings"));
    EXPECT_EQ(line("servo.timeout_mode").verdict, Verdict::Right) << "in force, but not stored";
    EXPECT_TRUE(driveCheck.isFixable());
    drive.canStore = true;
    driveCheck.fix();
    runUntilIdle();
    EXPECT_TRUE(driveCheck.fixTrouble().isEmpty());
    EXPECT_FALSE(driveCheck.isFixable());
}

}  // namespace
}  // namespace boresight::drive_check
