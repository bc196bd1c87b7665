// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/subframes.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

// The commands to a drive as values, and the register writes of each command. An empty field is not sent, and the drive
// then uses its own default. Some defaults are dangerous: a missing position means "go to 0.0". Units are those of the
// registers (output revolutions, rev/s, rev/s², Nm, s, A, V). Pure, any thread.
namespace boresight::moteus {

// A value and its resolution on the bus. The special values of the protocol are NaN or negative numbers. They have
// names here.
struct Field
{
    double value = 0.0;
    Resolution resolution = Resolution::Float;

    constexpr Field(double fieldValue,
                    Resolution fieldResolution = Resolution::Float)  // NOLINT: a plain number will do
        : value(fieldValue), resolution(fieldResolution)
    {}
};

inline constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kKeepControlPosition = kUnset;  // position: change only the velocity; with 0: stop and hold
inline constexpr double kNoWatchdog = kUnset;           // timeout: this command never ends
inline constexpr double kConfiguredTimeout = 0.0;       // timeout: use servo.default_timeout_s
inline constexpr double kConfiguredLimit = kUnset;      // velocity, acceleration limit: use the setting of the drive
inline constexpr double kNoLimit = -1.0;                // velocity, acceleration limit: no limit
inline constexpr double kCurrentLimitOnly = kUnset;     // maximum torque: only the current limit (0 is no torque)
inline constexpr double kNoBound = kUnset;              // stay within: no bound on this side

struct Stop  // driver off, axis free. The only way out of fault and time-out
{};

struct Brake  // phases shorted: passive damping, no holding torque, no watchdog
{};

struct ZeroVelocity  // damping only, no watchdog
{
    std::optional<Field> kdScale{};
};

// The drive follows position + velocity·t from the arrival of the command, within the limits.
struct PositionCommand
{
    std::optional<Field> position{};
    std::optional<Field> velocity{};
    std::optional<Field> feedforwardTorque{};
    std::optional<Field> kpScale{};
    std::optional<Field> kdScale{};
    std::optional<Field> maximumTorque{};
    std::optional<Field> stopPosition{};  // deprecated: fault 45 if any limit is in force
    std::optional<Field> watchdogTimeout{};
    std::optional<Field> velocityLimit{};
    std::optional<Field> accelerationLimit{};
    std::optional<Field> fixedVoltage{};
    std::optional<Field> integralLimitScale{};
    std::optional<Field> fixedCurrent{};
    std::optional<Field> ignorePositionBounds{};
    // The lower bound of StayWithin, which has no effect in this mode. The reply to the same frame reads it back.
    std::optional<Field> echo{};
    // The control set-points restart from the measured state before the command takes effect. This is no command
    // register.
    bool recapture = false;
};

struct StayWithin
{
    std::optional<Field> lower{};
    std::optional<Field> upper{};
    std::optional<Field> feedforwardTorque{};
    std::optional<Field> kpScale{};
    std::optional<Field> kdScale{};
    std::optional<Field> maximumTorque{};
    std::optional<Field> watchdogTimeout{};
    std::optional<Field> integralLimitScale{};
    std::optional<Field> ignorePositionBounds{};
};

// The five bench modes have no watchdog, so never leave one running.
struct PwmCommand
{
    std::optional<Field> a{}, b{}, c{};
};

struct VoltageCommand
{
    std::optional<Field> a{}, b{}, c{};
};

struct VoltageFocCommand
{
    std::optional<Field> theta{};  // rad, electrical
    std::optional<Field> voltage{};
    std::optional<Field> thetaRate{};  // rad/s
};

struct VoltageDqCommand
{
    std::optional<Field> d{}, q{};
};

struct CurrentCommand
{
    std::optional<Field> q{}, d{};
};

// The following commands write a register without a mode. They do not move the motor and do not feed the watchdog.
struct SetOutputNearest  // keep the phase of the encoder, choose the nearest whole turn of the rotor
{
    Field position = 0.0;
};

struct SetOutputExact  // make the current position this value
{
    Field position = 0.0;
};

struct RequireReindex
{};

struct RecapturePositionVelocity
{};

struct ClockTrim
{
    Field trim{0.0, Resolution::Int32};  // -8..8
};

// All digital outputs of one aux port. Bit 0 is pin 0. They stay until the board is without power, whatever becomes of
// this program.
struct SetOutputs
{
    int port = 1;
    std::uint8_t bits = 0;
};

using Command = std::variant<Stop, Brake, ZeroVelocity, PositionCommand, StayWithin, PwmCommand, VoltageCommand,
                             VoltageFocCommand, VoltageDqCommand, CurrentCommand, SetOutputNearest, SetOutputExact,
                             RequireReindex, RecapturePositionVelocity, ClockTrim, SetOutputs>;

// In register order. The mode is written first, because writing it resets every command field of the drive.
[[nodiscard]] std::vector<RegisterValue> registerWrites(const Command& command);

}  // namespace boresight::moteus
