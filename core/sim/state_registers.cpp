// SPDX-License-Identifier: GPL-3.0-or-later
// The registers and telemetry channels of SimulatedMoteus.
#include "core/moteus/count_origin.h"
#include "core/sim/command_registers.h"
#include "core/sim/encoder_report.h"
#include "core/sim/simulated_moteus.h"

#include <array>
#include <bit>
#include <cmath>

namespace boresight::sim {
namespace {

using moteus::Mode;
using moteus::Register;

constexpr std::uint32_t kUnknown = 1;  // error code: this value or register does not exist
constexpr int kFirmwareVersion = 0x010100;
constexpr double kVoltageStep = 0.018;                       // V, of the converter on the board
constexpr std::int64_t kCounterStart = 0x80000000 - 300000;  // overflows after five minutes, on purpose
constexpr std::uint8_t kFamily = 0;                          // r4.x
constexpr std::uint8_t kHardwareRevision = 8;                // r4.11

constexpr std::array<std::string_view, 16> kModeNames{
    "kStopped",  "kFault",           "kEnabling",     "kCalibrating",      "kCalibrationComplete",
    "kPwm",      "kVoltage",         "kVoltageFoc",   "kVoltageDq",        "kCurrent",
    "kPosition", "kPositionTimeout", "kZeroVelocity", "kStayWithinBounds", "kMeasureInductance",
    "kBrake"};

std::uint32_t index(Register reg, Register first)
{
    return static_cast<std::uint32_t>(reg) - static_cast<std::uint32_t>(first);
}

double identity(std::uint32_t word)
{
    return static_cast<double>(std::bit_cast<std::int32_t>(word));
}

std::uint32_t word(const std::array<std::uint8_t, 16>& bytes, std::uint32_t number)
{
    std::uint32_t value = 0;
    for (std::uint32_t i = 4; i-- > 0;) {
        value = value << 8 | bytes[number * 4 + i];
    }
    return value;
}

float single(double value)
{
    return static_cast<float>(value);
}

}  // namespace

double SimulatedMoteus::readRegister(Register reg)
{
    if (const auto commanded = readCommand(m_writes.command, reg)) {
        return *commanded;
    }
    if (const auto measured = readMeasured(reg)) {
        return *measured;
    }
    if (const auto control = readControl(reg)) {
        return *control;
    }
    if (const auto identity = readIdentity(reg)) {
        return *identity;
    }
    const auto found = m_writes.unused.find(reg);
    return found != m_writes.unused.end() ? found->second : readSensor(reg);
}

std::optional<double> SimulatedMoteus::readMeasured(Register reg) const
{
    const ServoOutput& output = m_servo->output();
    switch (reg) {
        case Register::Mode:
            return static_cast<double>(m_servo->mode());
        case Register::Position:
            return reportedPosition();
        case Register::Velocity:
            return m_encoder->velocity();
        case Register::Torque:
            return output.torque;
        case Register::QCurrent:
            return output.qCurrent;
        case Register::DCurrent:
            return output.dCurrent;
        case Register::AbsolutePosition:
            return m_config.motorPosition.referenceSource == 1 ? m_encoder->outputFractionOfTurn() : 0.0;
        case Register::Power:
            return output.power;
        case Register::MotorTemperature:
            return m_inputs.motorTemperature;
        case Register::TrajectoryComplete:
            return m_servo->trajectoryComplete() ? 1.0 : 0.0;
        case Register::HomeState:
            return static_cast<double>(m_encoder->homeState());
        case Register::Voltage:
            return std::floor(m_inputs.busVoltage / kVoltageStep) * kVoltageStep;
        case Register::Temperature:
            return m_board.celsius();
        case Register::Fault:
            return m_servo->faultCode();
        default:
            return std::nullopt;
    }
}

std::optional<double> SimulatedMoteus::readControl(Register reg) const
{
    const PidTerms& terms = m_servo->terms();
    const ControlState& control = m_servo->control();
    const bool exists = m_servo->controlsPosition();
    const auto whenControlled = [exists](double value) { return exists ? value : kNone; };
    switch (reg) {
        case Register::ProportionalTorque:
            return terms.proportional;
        case Register::IntegralTorque:
            return terms.integral;
        case Register::DerivativeTorque:
            return terms.derivative;
        case Register::FeedforwardTorque:
            return terms.feedforward;
        case Register::TotalTorque:
            return terms.total;
        case Register::ControlPosition:
            return whenControlled(control.position);
        case Register::ControlVelocity:
            return whenControlled(control.velocity);
        case Register::ControlTorque:
            return m_servo->controlTorque();
        case Register::PositionError:
            return whenControlled(m_inputs.position - control.position);
        case Register::VelocityError:
            return whenControlled(m_inputs.velocity - control.velocity);
        case Register::TorqueError:
            return m_servo->output().torque - m_servo->controlTorque();
        default:
            return std::nullopt;
    }
}

std::optional<double> SimulatedMoteus::readIdentity(Register reg) const
{
    if (const std::uint32_t number = index(reg, Register::Uuid); number < 4) {
        return identity(word(m_config.uuid, number));
    }
    if (const std::uint32_t number = index(reg, Register::SerialNumber); number < 3) {
        return identity(word(m_config.uuid, number + 1));
    }
    switch (reg) {
        case Register::ModelNumber:
            return 0.0;
        case Register::FirmwareVersion:
            return kFirmwareVersion;
        case Register::RegisterMapVersion:
            return m_registerMapVersion;
        case Register::UuidMaskCapable:
            return 1.0;
        default:
            return std::nullopt;
    }
}

// Encoders and the clock; what this board does not have (other encoders, analog pins, driver faults) reads 0.
double SimulatedMoteus::readSensor(Register reg) const
{
    const bool second = m_config.motorPosition.referenceSource == 1;
    switch (reg) {
        case Register::Encoder0Position:
            return m_encoder->fractionOfTurn();
        case Register::Encoder0Velocity:
            return m_encoder->velocity() /
                   (m_config.motorPosition.rotorToOutputRatio * m_config.motorPosition.outputSign);
        case Register::Encoder1Position:
            return second ? m_encoder->outputFractionOfTurn() : 0.0;
        case Register::Encoder1Velocity:
            return second ? m_plant.velocity() : 0.0;
        case Register::EncoderValidity:
            return second ? 0b1111 : 0b0011;
        case Register::MillisecondCounter: {
            const auto count = static_cast<std::uint32_t>(kCounterStart + std::llround(m_uptime * 1000.0));
            return static_cast<double>(std::bit_cast<std::int32_t>(count));
        }
        default:
            return 0.0;
    }
}

std::uint32_t SimulatedMoteus::writeRegister(Register reg, double value)
{
    if (reg == Register::Mode) {
        if (!(value >= 0.0 && value < moteus::kModeCount)) {
            return kUnknown;
        }
        m_writes.command = {.mode = static_cast<Mode>(static_cast<int>(value))};
        m_writes.hasMode = true;
        return 0;
    }
    if (writeCommand(m_writes.command, reg, value)) {
        return 0;
    }
    if (reg >= Register::SetOutputNearest && reg <= Register::RecapturePositionVelocity) {
        m_writes.actions.push_back({.reg = reg, .value = value});
        return 0;
    }
    m_writes.unused[reg] = value;
    return 0;
}

std::vector<std::string> SimulatedMoteus::telemetryChannels() const
{
    return {"firmware", "git", "servo_stats", moteus::kMotorPositionChannel};
}

std::vector<ArchiveField> SimulatedMoteus::telemetry(std::string_view channel)
{
    if (channel == "firmware") {
        return {{"version", ArchiveUnsigned{kFirmwareVersion, 4}},
                {"serial_number",
                 ArchiveArray{{word(m_config.uuid, 1), word(m_config.uuid, 2), word(m_config.uuid, 3)}, 4}},
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
        return encoderReport(*m_encoder);
    }
    return channel == "servo_stats" ? servoStats() : std::vector<ArchiveField>{};
}

std::vector<ArchiveField> SimulatedMoteus::servoStats() const
{
    const ServoOutput& output = m_servo->output();
    const ControlState& control = m_servo->control();
    return {{"mode", ArchiveEnum{static_cast<std::uint32_t>(m_servo->mode()), kModeNames}},
            {"fault", ArchiveEnum{static_cast<std::uint32_t>(m_servo->faultCode()), {}}},
            {"bus_V", single(m_inputs.busVoltage)},
            {"filt_bus_V", single(m_inputs.busVoltage)},
            {"fet_temp_C", single(m_board.celsius())},
            {"motor_temp_C", single(m_inputs.motorTemperature)},
            {"d_A", single(output.dCurrent)},
            {"q_A", single(output.qCurrent)},
            {"position", single(m_encoder->position())},
            {"velocity", single(m_encoder->velocity())},
            {"torque_Nm", single(output.torque)},
            {"power_W", single(output.power)},
            {"control_position", single(control.position)},
            {"control_velocity", single(control.velocity)},
            {"trajectory_done", m_servo->trajectoryComplete()}};
}

}  // namespace boresight::sim
