// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/registers.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

namespace boresight::moteus {
namespace {

// One row is one register, or `count` registers of the same kind with consecutive numbers.
struct Row
{
    Register first;
    std::uint32_t count;
    Kind kind;
    Access access;
    std::string_view name;
};

constexpr auto R = Access::Read;
constexpr auto W = Access::Write;
constexpr auto RW = Access::ReadWrite;

// Sorted by number for the binary search.
constexpr std::array kRegistersRows{
    Row{Register::Mode, 1, Kind::Integer, RW, "mode"},
    Row{Register::Position, 1, Kind::Position, R, "position"},
    Row{Register::Velocity, 1, Kind::Velocity, R, "velocity"},
    Row{Register::Torque, 1, Kind::Torque, R, "torque"},
    Row{Register::QCurrent, 1, Kind::Current, R, "q current"},
    Row{Register::DCurrent, 1, Kind::Current, R, "d current"},
    Row{Register::AbsolutePosition, 1, Kind::Position, R, "absolute position"},
    Row{Register::Power, 1, Kind::Power, R, "power"},
    Row{Register::MotorTemperature, 1, Kind::Temperature, R, "motor temperature"},
    Row{Register::TrajectoryComplete, 1, Kind::Integer, R, "trajectory complete"},
    Row{Register::HomeState, 1, Kind::Integer, R, "home state"},
    Row{Register::Voltage, 1, Kind::Voltage, R, "voltage"},
    Row{Register::Temperature, 1, Kind::Temperature, R, "temperature"},
    Row{Register::Fault, 1, Kind::Integer, R, "fault"},
    Row{Register::PwmPhaseA, 1, Kind::Fraction, RW, "PWM phase A"},
    Row{Register::PwmPhaseB, 1, Kind::Fraction, RW, "PWM phase B"},
    Row{Register::PwmPhaseC, 1, Kind::Fraction, RW, "PWM phase C"},
    Row{Register::VoltagePhaseA, 1, Kind::Voltage, RW, "voltage phase A"},
    Row{Register::VoltagePhaseB, 1, Kind::Voltage, RW, "voltage phase B"},
    Row{Register::VoltagePhaseC, 1, Kind::Voltage, RW, "voltage phase C"},
    Row{Register::VfocTheta, 1, Kind::Fraction, RW, "voltage FOC theta (half turns)"},
    Row{Register::VfocVoltage, 1, Kind::Voltage, RW, "voltage FOC voltage"},
    Row{Register::DVoltage, 1, Kind::Voltage, RW, "d voltage"},
    Row{Register::QVoltage, 1, Kind::Voltage, RW, "q voltage"},
    Row{Register::CommandQCurrent, 1, Kind::Current, RW, "commanded q current"},
    Row{Register::CommandDCurrent, 1, Kind::Current, RW, "commanded d current"},
    Row{Register::VfocThetaRate, 1, Kind::Velocity, RW, "voltage FOC theta rate"},
    Row{Register::CommandPosition, 1, Kind::Position, RW, "commanded position"},
    Row{Register::CommandVelocity, 1, Kind::Velocity, RW, "commanded velocity"},
    Row{Register::CommandFeedforwardTorque, 1, Kind::Torque, RW, "commanded feedforward torque"},
    Row{Register::CommandKpScale, 1, Kind::Fraction, RW, "kp scale"},
    Row{Register::CommandKdScale, 1, Kind::Fraction, RW, "kd scale"},
    Row{Register::CommandMaximumTorque, 1, Kind::Torque, RW, "maximum torque"},
    Row{Register::CommandStopPosition, 1, Kind::Position, RW, "stop position"},
    Row{Register::CommandWatchdogTimeout, 1, Kind::Time, RW, "watchdog timeout"},
    Row{Register::CommandVelocityLimit, 1, Kind::Velocity, RW, "velocity limit"},
    Row{Register::CommandAccelerationLimit, 1, Kind::Acceleration, RW, "acceleration limit"},
    Row{Register::CommandFixedVoltage, 1, Kind::Voltage, RW, "fixed voltage override"},
    Row{Register::CommandIntegralLimitScale, 1, Kind::Fraction, RW, "integral limit scale"},
    Row{Register::CommandFixedCurrent, 1, Kind::Current, RW, "fixed current override"},
    Row{Register::CommandIgnorePositionBounds, 1, Kind::Integer, RW, "ignore position bounds"},
    Row{Register::ProportionalTorque, 1, Kind::Torque, R, "proportional torque"},
    Row{Register::IntegralTorque, 1, Kind::Torque, R, "integral torque"},
    Row{Register::DerivativeTorque, 1, Kind::Torque, R, "derivative torque"},
    Row{Register::FeedforwardTorque, 1, Kind::Torque, R, "feedforward torque"},
    Row{Register::TotalTorque, 1, Kind::Torque, R, "total torque"},
    Row{Register::ControlPosition, 1, Kind::Position, R, "control position"},
    Row{Register::ControlVelocity, 1, Kind::Velocity, R, "control velocity"},
    Row{Register::ControlTorque, 1, Kind::Torque, R, "control torque"},
    Row{Register::PositionError, 1, Kind::Position, R, "position error"},
    Row{Register::VelocityError, 1, Kind::Velocity, R, "velocity error"},
    Row{Register::TorqueError, 1, Kind::Torque, R, "torque error"},
    Row{Register::StayWithinLower, 1, Kind::Position, RW, "lower bound"},
    Row{Register::StayWithinUpper, 1, Kind::Position, RW, "upper bound"},
    Row{Register::StayWithinFeedforwardTorque, 1, Kind::Torque, RW, "stay-within feedforward torque"},
    Row{Register::StayWithinKpScale, 1, Kind::Fraction, RW, "stay-within kp scale"},
    Row{Register::StayWithinKdScale, 1, Kind::Fraction, RW, "stay-within kd scale"},
    Row{Register::StayWithinMaximumTorque, 1, Kind::Torque, RW, "stay-within maximum torque"},
    Row{Register::StayWithinWatchdogTimeout, 1, Kind::Time, RW, "stay-within watchdog timeout"},
    Row{Register::StayWithinIntegralLimitScale, 1, Kind::Fraction, RW, "stay-within integral limit scale"},
    Row{Register::StayWithinIgnorePositionBounds, 1, Kind::Integer, RW, "stay-within ignore position bounds"},
    Row{Register::Encoder0Position, 1, Kind::Position, R, "encoder 0 position"},
    Row{Register::Encoder0Velocity, 1, Kind::Velocity, R, "encoder 0 velocity"},
    Row{Register::Encoder1Position, 1, Kind::Position, R, "encoder 1 position"},
    Row{Register::Encoder1Velocity, 1, Kind::Velocity, R, "encoder 1 velocity"},
    Row{Register::Encoder2Position, 1, Kind::Position, R, "encoder 2 position"},
    Row{Register::Encoder2Velocity, 1, Kind::Velocity, R, "encoder 2 velocity"},
    Row{Register::EncoderValidity, 1, Kind::Integer, R, "encoder validity"},
    Row{Register::AuxGpioCommand, 2, Kind::Integer, RW, "aux GPIO command"},
    Row{Register::AuxGpioStatus, 2, Kind::Integer, R, "aux GPIO status"},
    Row{Register::Aux1AnalogIn, 5, Kind::Fraction, R, "aux 1 analog input"},
    Row{Register::Aux2AnalogIn, 5, Kind::Fraction, R, "aux 2 analog input"},
    Row{Register::MillisecondCounter, 1, Kind::Counter, R, "millisecond counter"},
    Row{Register::ClockTrim, 1, Kind::Integer, RW, "clock trim"},
    Row{Register::Aux1PwmInputPeriod, 1, Kind::Integer, R, "aux 1 PWM input period"},
    Row{Register::Aux1PwmInputDutyCycle, 1, Kind::Fraction, R, "aux 1 PWM input duty cycle"},
    Row{Register::Aux2PwmInputPeriod, 1, Kind::Integer, R, "aux 2 PWM input period"},
    Row{Register::Aux2PwmInputDutyCycle, 1, Kind::Fraction, R, "aux 2 PWM input duty cycle"},
    Row{Register::Aux1PwmOutput, 5, Kind::Fraction, RW, "aux 1 PWM output"},
    Row{Register::Aux2PwmOutput, 5, Kind::Fraction, RW, "aux 2 PWM output"},
    Row{Register::ModelNumber, 1, Kind::Identity, R, "model number"},
    Row{Register::FirmwareVersion, 1, Kind::Identity, R, "firmware version"},
    Row{Register::RegisterMapVersion, 1, Kind::Identity, R, "register map version"},
    Row{Register::MultiplexId, 1, Kind::Integer, Access::None, "multiplex id"},
    Row{Register::SerialNumber, 3, Kind::Identity, R, "serial number"},
    Row{Register::SetOutputNearest, 1, Kind::Position, W, "set output nearest"},
    Row{Register::SetOutputExact, 1, Kind::Position, W, "set output exact"},
    Row{Register::RequireReindex, 1, Kind::Integer, W, "require reindex"},
    Row{Register::RecapturePositionVelocity, 1, Kind::Integer, W, "recapture position and velocity"},
    Row{Register::DriverFault1, 1, Kind::Integer, R, "gate driver fault bits 1"},
    Row{Register::DriverFault2, 1, Kind::Integer, R, "gate driver fault bits 2"},
    Row{Register::Uuid, 4, Kind::Identity, R, "UUID"},
    Row{Register::UuidMask, 4, Kind::Identity, W, "UUID mask"},
    Row{Register::UuidMaskCapable, 1, Kind::Integer, R, "UUID mask capable"},
};
static_assert(std::ranges::is_sorted(kRegistersRows, {}, &Row::first));

const Row* findRow(Register reg)
{
    const auto after = std::ranges::upper_bound(kRegistersRows, reg, {}, &Row::first);
    if (after == kRegistersRows.begin()) {
        return nullptr;
    }
    const Row& row = *std::prev(after);
    return reg < row.first + row.count ? &row : nullptr;
}

std::string nameOf(const Row& row, Register reg)
{
    std::string name(row.name);
    if (row.count > 1) {
        name += ' ' + std::to_string(static_cast<std::uint32_t>(reg) - static_cast<std::uint32_t>(row.first) + 1);
    }
    return name;
}

}  // namespace

std::optional<RegisterInfo> registerInfo(Register reg)
{
    const Row* row = findRow(reg);
    if (row == nullptr) {
        return std::nullopt;
    }
    return RegisterInfo{nameOf(*row, reg), row->kind, row->access};
}

std::optional<Kind> registerKind(Register reg)
{
    const Row* row = findRow(reg);
    return row == nullptr ? std::nullopt : std::optional(row->kind);
}

bool isReadable(Register reg)
{
    const Row* row = findRow(reg);
    return row != nullptr && (row->access == R || row->access == RW);
}

bool isWritable(Register reg)
{
    const Row* row = findRow(reg);
    return row != nullptr && (row->access == W || row->access == RW);
}

std::string registerName(Register reg)
{
    if (const Row* row = findRow(reg)) {
        return nameOf(*row, reg);
    }
    std::ostringstream text;
    text << "unknown register 0x" << std::hex << static_cast<std::uint32_t>(reg);
    return text.str();
}

std::string_view unitText(Kind kind)
{
    switch (kind) {
        case Kind::Position:
            return "rev";
        case Kind::Velocity:
            return "rev/s";
        case Kind::Acceleration:
            return "rev/s²";
        case Kind::Torque:
            return "Nm";
        case Kind::Current:
            return "A";
        case Kind::Temperature:
            return "°C";
        case Kind::Voltage:
            return "V";
        case Kind::Power:
            return "W";
        case Kind::Time:
            return "s";
        case Kind::Fraction:
        case Kind::Integer:
        case Kind::Counter:
        case Kind::Identity:
            return {};
    }
    return {};
}

std::string_view resolutionText(Resolution r)
{
    static constexpr std::array<std::string_view, 4> kTexts{"i8", "i16", "i32", "f32"};
    return kTexts[static_cast<std::size_t>(r)];
}

std::size_t sizeInBytes(Resolution r)
{
    static constexpr std::array<std::size_t, 4> kSizes{1, 2, 4, 4};
    return kSizes[static_cast<std::size_t>(r)];
}

}  // namespace boresight::moteus
