// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/state_registers.h"

#include <bit>
#include <cmath>

namespace boresight::sim {
namespace {

using moteus::Register;

constexpr auto kSecondPort = static_cast<Register>(static_cast<std::uint32_t>(Register::AuxGpioStatus) + 1);
constexpr double kPositionCount = 1.0 / 65536.0;
constexpr double kVoltageStep = 0.018;                       // V: step of the converter on the board
constexpr std::int64_t kCounterStart = 0x80000000 - 300000;  // overflows after 5 min, for tests

std::uint32_t index(Register reg, Register first)
{
    return static_cast<std::uint32_t>(reg) - static_cast<std::uint32_t>(first);
}

double counted(double position)
{
    return std::floor(position / kPositionCount) * kPositionCount;
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

std::optional<double> readMeasured(const DriveState& drive, Register reg)
{
    const ServoOutput& output = drive.servo.output();
    switch (reg) {
        case Register::Mode:
            return static_cast<double>(drive.servo.mode());
        case Register::Position:
            return counted(drive.encoder.position());
        case Register::Velocity:
            return drive.encoder.velocity();
        case Register::Torque:
            return output.torque;
        case Register::QCurrent:
            return output.qCurrent;
        case Register::DCurrent:
            return output.dCurrent;
        case Register::AbsolutePosition:
            return drive.config.motorPosition.referenceSource == 1 ? drive.encoder.outputFractionOfTurn() : 0.0;
        case Register::Power:
            return output.power;
        case Register::MotorTemperature:
            return drive.inputs.motorTemperature;
        case Register::TrajectoryComplete:
            return drive.servo.trajectoryComplete() ? 1.0 : 0.0;
        case Register::HomeState:
            return static_cast<double>(drive.encoder.homeState());
        case Register::Voltage:
            return std::floor(drive.inputs.busVoltage / kVoltageStep) * kVoltageStep;
        case Register::Temperature:
            return drive.board.celsius();
        case Register::Fault:
            return drive.servo.faultCode();
        default:
            return std::nullopt;
    }
}

std::optional<double> readControl(const DriveState& drive, Register reg)
{
    const PidTerms& terms = drive.servo.terms();
    const ControlState& control = drive.servo.control();
    const bool exists = drive.servo.controlsPosition();
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
            return whenControlled(counted(control.position));
        case Register::ControlVelocity:
            return whenControlled(control.velocity);
        case Register::ControlTorque:
            return drive.servo.controlTorque();
        case Register::PositionError:
            return whenControlled(drive.inputs.position - control.position);
        case Register::VelocityError:
            return whenControlled(drive.inputs.velocity - control.velocity);
        case Register::TorqueError:
            return drive.servo.output().torque - drive.servo.controlTorque();
        default:
            return std::nullopt;
    }
}

std::optional<double> readIdentity(const DriveState& drive, Register reg)
{
    if (const std::uint32_t number = index(reg, Register::Uuid); number < 4) {
        return identity(word(drive.config.uuid, number));
    }
    if (const std::uint32_t number = index(reg, Register::SerialNumber); number < 3) {
        return identity(word(drive.config.uuid, number + 1));
    }
    switch (reg) {
        case Register::ModelNumber:
            return 0.0;
        case Register::FirmwareVersion:
            return kFirmwareVersion;
        case Register::RegisterMapVersion:
            return drive.registerMapVersion;
        case Register::UuidMaskCapable:
            return 1.0;
        default:
            return std::nullopt;
    }
}

}  // namespace

std::optional<double> readState(const DriveState& drive, Register reg)
{
    if (const auto measured = readMeasured(drive, reg)) {
        return measured;
    }
    const auto control = readControl(drive, reg);
    return control ? control : readIdentity(drive, reg);
}

double readSensor(const DriveState& drive, Register reg)
{
    const bool second = drive.config.motorPosition.referenceSource == 1;
    switch (reg) {
        case Register::Encoder0Position:
            return drive.encoder.fractionOfTurn();
        case Register::Encoder0Velocity:
            return drive.encoder.velocity() /
                   (drive.config.motorPosition.rotorToOutputRatio * drive.config.motorPosition.outputSign);
        case Register::Encoder1Position:
            return second ? drive.encoder.outputFractionOfTurn() : 0.0;
        case Register::Encoder1Velocity:
            return second ? drive.plant.velocity() : 0.0;
        case Register::EncoderValidity:
            return second ? 0b1111 : 0b0011;
        case Register::MillisecondCounter: {
            const auto count = static_cast<std::uint32_t>(kCounterStart + std::llround(drive.uptime * 1000.0));
            return static_cast<double>(std::bit_cast<std::int32_t>(count));
        }
        case Register::AuxGpioStatus:
            return drive.pins[0];
        case kSecondPort:
            return drive.pins[1];
        default:
            return 0.0;
    }
}

std::array<std::uint32_t, 3> serialNumber(const DriveConfig& config)
{
    return {word(config.uuid, 1), word(config.uuid, 2), word(config.uuid, 3)};
}

}  // namespace boresight::sim
