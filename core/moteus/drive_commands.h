// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/subframes.h"

#include <limits>
#include <optional>
#include <variant>
#include <vector>

// What a drive can be told, as values, and the register writes each becomes. A field that is empty is not sent, and
// the drive then uses its own default, which is not always harmless: an absent position means "go to 0.0". Units are
// those of the registers (output revolutions, rev/s, rev/s², Nm, s, A, V). Pure, any thread.
namespace boresight::moteus {

// A value and how it travels. The special values of the protocol are NaN or negative on the wire; here they have names.
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
inline constexpr double kNoWatchdog = kUnset;           // timeout: this command lasts for ever
inline constexpr double kConfiguredTimeout = 0.0;       // timeout: servo.default_timeout_s
inline constexpr double kConfiguredLimit = kUnset;      // velocity, acceleration limit: the drive's own setting
inline constexpr double kNoLimit = -1.0;                // velocity, acceleration limit: none
inline constexpr double kCurrentLimitOnly = kUnset;     // maximum torque: what the current limit allows (0 is limp)
inline constexpr double kNoBound = kUnset;              // stay within: this side is open

struct Stop  // driver off, axis free; the only way out of fault and timeout
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
    std::optional<Field> stopPosition{};  // deprecated: fault 45 with any limit in force
    std::optional<Field> watchdogTimeout{};
    std::optional<Field> velocityLimit{};
    std::optional<Field> accelerationLimit{};
    std::optional<Field> fixedVoltage{};
    std::optional<Field> integralLimitScale{};
    std::optional<Field> fixedCurrent{};
    std::optional<Field> ignorePositionBounds{};
    // The lower bound of StayWithin, which means nothing in this mode. The reply to this very frame reads it back.
    std::optional<Field> echo{};
    // Before the command counts, the control set-points restart from the measured state. No command register.
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

// The five bench modes have no watchdog: never leave one running.
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

// The following four write a register without a mode: no motion command, they do not feed the watchdog.
struct SetOutputNearest  // keep the encoder's phase, choose the whole rotor turn nearest to this
{
    Field position = 0.0;
};

struct SetOutputExact  // make the present position read this
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

using Command = std::variant<Stop, Brake, ZeroVelocity, PositionCommand, StayWithin, PwmCommand, VoltageCommand,
                             VoltageFocCommand, VoltageDqCommand, CurrentCommand, SetOutputNearest, SetOutputExact,
                             RequireReindex, RecapturePositionVelocity, ClockTrim>;

// In register order, the mode first: writing it resets every command field of the drive.
[[nodiscard]] std::vector<RegisterValue> registerWrites(const Command& command);

}  // namespace boresight::moteus
