// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// The register map of moteus, version 5: number, name, kind of quantity, access. Pure values, any thread. Positions,
// velocities and torques are those of the gearbox output (revolutions, rev/s, Nm).
namespace boresight::moteus {

inline constexpr int kRegisterMapVersion = 5;  // Boresight moves only drives with this value in register 0x102

enum class Register : std::uint32_t
{
    Mode = 0x000,
    Position = 0x001,
    Velocity = 0x002,
    Torque = 0x003,
    QCurrent = 0x004,
    DCurrent = 0x005,
    AbsolutePosition = 0x006,
    Power = 0x007,
    MotorTemperature = 0x00a,
    TrajectoryComplete = 0x00b,
    HomeState = 0x00c,
    Voltage = 0x00d,
    Temperature = 0x00e,
    Fault = 0x00f,
    PwmPhaseA = 0x010,
    PwmPhaseB = 0x011,
    PwmPhaseC = 0x012,
    VoltagePhaseA = 0x014,
    VoltagePhaseB = 0x015,
    VoltagePhaseC = 0x016,
    VfocTheta = 0x018,  // in half turns (units of pi)
    VfocVoltage = 0x019,
    DVoltage = 0x01a,
    QVoltage = 0x01b,
    CommandQCurrent = 0x01c,
    CommandDCurrent = 0x01d,
    VfocThetaRate = 0x01e,  // in half turns per second
    CommandPosition = 0x020,
    CommandVelocity = 0x021,
    CommandFeedforwardTorque = 0x022,
    CommandKpScale = 0x023,
    CommandKdScale = 0x024,
    CommandMaximumTorque = 0x025,
    CommandStopPosition = 0x026,
    CommandWatchdogTimeout = 0x027,
    CommandVelocityLimit = 0x028,
    CommandAccelerationLimit = 0x029,
    CommandFixedVoltage = 0x02a,
    CommandIntegralLimitScale = 0x02b,
    CommandFixedCurrent = 0x02c,
    CommandIgnorePositionBounds = 0x02d,
    ProportionalTorque = 0x030,
    IntegralTorque = 0x031,
    DerivativeTorque = 0x032,
    FeedforwardTorque = 0x033,
    TotalTorque = 0x034,
    ControlPosition = 0x038,
    ControlVelocity = 0x039,
    ControlTorque = 0x03a,
    PositionError = 0x03b,
    VelocityError = 0x03c,
    TorqueError = 0x03d,
    StayWithinLower = 0x040,
    StayWithinUpper = 0x041,
    StayWithinFeedforwardTorque = 0x042,
    StayWithinKpScale = 0x043,
    StayWithinKdScale = 0x044,
    StayWithinMaximumTorque = 0x045,
    StayWithinWatchdogTimeout = 0x046,
    StayWithinIntegralLimitScale = 0x047,
    StayWithinIgnorePositionBounds = 0x048,
    Encoder0Position = 0x050,
    Encoder0Velocity = 0x051,
    Encoder1Position = 0x052,
    Encoder1Velocity = 0x053,
    Encoder2Position = 0x054,
    Encoder2Velocity = 0x055,
    EncoderValidity = 0x058,
    AuxGpioCommand = 0x05c,  // two: aux port 1, 2
    AuxGpioStatus = 0x05e,   // two: aux port 1, 2
    Aux1AnalogIn = 0x060,    // five pins
    Aux2AnalogIn = 0x068,    // five pins
    MillisecondCounter = 0x070,
    ClockTrim = 0x071,
    Aux1PwmInputPeriod = 0x072,
    Aux1PwmInputDutyCycle = 0x073,
    Aux2PwmInputPeriod = 0x074,
    Aux2PwmInputDutyCycle = 0x075,
    Aux1PwmOutput = 0x076,  // five pins
    Aux2PwmOutput = 0x07b,  // five pins
    ModelNumber = 0x100,
    FirmwareVersion = 0x101,
    RegisterMapVersion = 0x102,
    MultiplexId = 0x110,   // exists, but can be neither read nor written
    SerialNumber = 0x120,  // three words
    SetOutputNearest = 0x130,
    SetOutputExact = 0x131,
    RequireReindex = 0x132,
    RecapturePositionVelocity = 0x133,
    DriverFault1 = 0x140,
    DriverFault2 = 0x141,
    Uuid = 0x150,      // four words
    UuidMask = 0x154,  // four words
    UuidMaskCapable = 0x158,
};

// The register with the number first + offset.
[[nodiscard]] constexpr Register operator+(Register first, std::uint32_t offset)
{
    return static_cast<Register>(static_cast<std::uint32_t>(first) + offset);
}

// The quantity of a register decides how integers are scaled (scaling.h).
enum class Kind : std::uint8_t
{
    Position,
    Velocity,
    Acceleration,
    Torque,
    Current,
    Temperature,
    Voltage,
    Power,
    Time,
    Fraction,  // PWM, gain scales, analog inputs
    Integer,   // mode, fault, flags: no scaling, no "unset"
    Counter,   // overflows instead of saturating
    Identity,  // 32 raw bits; only as i32
};

enum class Access : std::uint8_t
{
    None,
    Read,
    Write,
    ReadWrite,
};

// The format of a value on the bus: two bits of every register subframe.
enum class Resolution : std::uint8_t
{
    Int8 = 0,
    Int16 = 1,
    Int32 = 2,
    Float = 3,
};

enum class Mode : std::uint8_t
{
    Stopped = 0,
    Fault = 1,
    Enabling = 2,
    Calibrating = 3,
    CalibrationComplete = 4,
    Pwm = 5,
    Voltage = 6,
    VoltageFoc = 7,
    VoltageDq = 8,
    Current = 9,
    Position = 10,
    PositionTimeout = 11,
    ZeroVelocity = 12,
    StayWithin = 13,
    MeasureInductance = 14,
    Brake = 15,
};
inline constexpr int kModeCount = 16;

enum class HomeState : std::uint8_t
{
    Relative = 0,
    Rotor = 1,   // known only within one turn of the rotor
    Output = 2,  // the output is referenced
};

struct RegisterInfo
{
    std::string name;
    Kind kind = Kind::Integer;
    Access access = Access::None;
};

// Empty for a number that is not in the map.
[[nodiscard]] std::optional<RegisterInfo> registerInfo(Register reg);
[[nodiscard]] std::optional<Kind> registerKind(Register reg);
[[nodiscard]] bool isReadable(Register reg);
[[nodiscard]] bool isWritable(Register reg);

[[nodiscard]] std::string registerName(Register reg);         // "position", "UUID 2", "unknown register 0x2e"
[[nodiscard]] std::string_view unitText(Kind kind);           // "rev", "A"; empty without a unit
[[nodiscard]] std::string_view resolutionText(Resolution r);  // "i8", "i16", "i32", "f32"
[[nodiscard]] std::size_t sizeInBytes(Resolution r);

}  // namespace boresight::moteus
