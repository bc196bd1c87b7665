// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/drive_telemetry.h"

#include "core/moteus/count_origin.h"
#include "core/sim/encoder_report.h"

#include <array>
#include <cstdint>

namespace boresight::sim {
namespace {

constexpr std::uint8_t kFamily = 0;            // r4.x
constexpr std::uint8_t kHardwareRevision = 8;  // r4.11

constexpr std::array<std::string_view, 16> kModeNames{
    "kStopped",  "kFault",           "kEnabling",     "kCalibrating",      "kCalibrationComplete",
    "kPwm",      "kVoltage",         "kVoltageFoc",   "kVoltageDq",        "kCurrent",
    "kPosition", "kPositionTimeout", "kZeroVelocity", "kStayWithinBounds", "kMeasureInductance",
    "kBrake"};

float single(double value)
{
    return static_cast<float>(value);
}

std::vector<ArchiveField> servoStats(const DriveState& drive)
{
    const ServoOutput& output = drive.servo.output();
    const ControlState& control = drive.servo.control();
    return {{"mode", ArchiveEnum{static_cast<std::uint32_t>(drive.servo.mode()), kModeNames}},
            {"fault", ArchiveEnum{static_cast<std::uint32_t>(drive.servo.faultCode()), {}}},
            {"bus_V", single(drive.inputs.busVoltage)},
            {"filt_bus_V", single(drive.inputs.busVoltage)},
            {"fet_temp_C", single(drive.board.celsius())},
            {"motor_temp_C", single(drive.inputs.motorTemperature)},
            {"d_A", single(output.dCurrent)},
            {"q_A", single(output.qCurrent)},
            {"position", single(drive.encoder.position())},
            {"velocity", single(drive.encoder.velocity())},
            {"torque_Nm", single(output.torque)},
            {"power_W", single(output.power)},
            {"control_position", single(control.position)},
            {"control_velocity", single(control.velocity)},
            {"trajectory_done", drive.servo.trajectoryComplete()}};
}

}  // namespace

std::vector<std::string> telemetryChannels()
{
    return {"firmware", "git", "servo_stats", moteus::kMotorPositionChannel};
}

std::vector<ArchiveField> telemetry(const DriveState& drive, std::string_view channel)
{
    if (channel == "firmware") {
        const std::array<std::uint32_t, 3> serial = serialNumber(drive.config);
        return {{"version", ArchiveUnsigned{kFirmwareVersion, 4}},
                {"serial_number", ArchiveArray{{serial.begin(), serial.end()}, 4}},
                {"model", ArchiveUnsigned{0, 4}},
                {"family", ArchiveUnsigned{kFamily, 1}},
                {"hwrev", ArchiveUnsigned{kHardwareRevision, 1}}};
    }
    if (channel == "git") {
        return {{"hash", ArchiveArray{std::vector<std::uint32_t>(20, 0), 1}},
                {"dirty", false},
                {"timestamp", ArchiveUnsigned{0, 8}}};
    }
    if (channel == moteus::kMotorPositionChannel) {
        return encoderReport(drive.encoder);
    }
    return channel == "servo_stats" ? servoStats(drive) : std::vector<ArchiveField>{};
}

}  // namespace boresight::sim
