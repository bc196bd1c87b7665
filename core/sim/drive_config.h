// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/sky.h"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <variant>

// The configuration tree of one simulated moteus: the keys of its `conf` commands that have an effect in the simulator,
// with the defaults of the factory. Units are those of the device: turns of the output, Nm, A, V, °C, s. As in the
// device, NaN means "none".
namespace boresight::sim {

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct ServoGains
{
    double kp = 4.0;  // Nm/turn of the output
    double ki = 1.0;
    double kd = 0.05;
    double iratelimit = -1.0;  // Nm/s; negative: no limit
    double ilimit = 0.0;       // Nm; the factory default switches the integrator off
};

struct ServoConfig
{
    double maxVoltage = 46.0;
    double maxPower = kNone;  // none: only the limit of the board
    double temperatureMargin = 25.0;
    double faultTemperature = 75.0;
    bool enableMotorTemperature = false;
    double motorTemperatureMargin = 20.0;
    double motorFaultTemperature = kNone;
    double faultPositionError = kNone;
    double faultVelocityError = kNone;
    double positionDerate = 0.02;
    ServoGains gains;
    double inertiaFeedforward = 0.0;  // kg·m² at the output: torque per acceleration of the planner of the drive
    double defaultVelocityLimit = kNone;
    double defaultAccelLimit = 50.0;
    double maxPositionSlip = kNone;
    double defaultTimeout = 0.1;
    double timeoutMaxTorque = 5.0;
    int timeoutMode = 12;
    double fluxBrakeMarginVoltage = 3.0;
    double fluxBrakeResistance = 0.025;
    double maxCurrent = 100.0;
    double maxVelocity = 500.0;
    double maxVelocityDerate = 2.0;
    double velocityZeroCaptureThreshold = 0.05;
};

struct MotorConfig
{
    int poles = 14;
    bool phaseInvert = false;
    double resistance = 0.1;  // Ω, phase
    double kv = 300.0;        // rpm/V; 0: not calibrated
};

struct MotorPositionConfig
{
    double rotorToOutputRatio = 1.0;
    int outputSource = 0;
    double outputOffset = 0.0;
    int outputSign = 1;
    double pllFilter = 400.0;  // Hz: filter of the measured velocity
    int referenceSource = -1;  // 1: an absolute encoder on the output, so the position is known after power-up
};

// The functions of the pins of both aux ports, by their numbers in the device. The pins of the simulated boards are
// digital inputs.
struct PinConfig
{
    static constexpr int kDigitalInput = 14;

    std::array<std::array<int, 5>, 2> modes = [] {
        std::array<std::array<int, 5>, 2> inputs{};
        for (auto& port : inputs) {
            port.fill(kDigitalInput);
        }
        return inputs;
    }();
};

struct ReferenceAxis;

struct DriveConfig
{
    int id = 1;
    int canPrefix = 0;
    std::array<std::uint8_t, 16> uuid{};
    ServoConfig servo;
    double positionMin = -0.01;
    double positionMax = 0.01;
    MotorConfig motor;
    MotorPositionConfig motorPosition;
    PinConfig pins;

    // aux1.pins.0 is port 1, pin 0.
    [[nodiscard]] int& pinMode(int port, int pin)
    {
        return pins.modes.at(static_cast<std::size_t>(port - 1)).at(static_cast<std::size_t>(pin));
    }
};

// A pointer into a DriveConfig. A byte is one element of an array.
using ConfigField = std::variant<double*, int*, bool*, std::uint8_t*>;
using ConfigVisitor = std::function<void(std::string_view key, ConfigField field)>;

// Visits every key once, by groups, in the order of `conf enumerate`.
void visitFields(DriveConfig& config, const ConfigVisitor& visit);

// As in the device, a text that is no number counts as 0.
[[nodiscard]] Result<std::string> configText(DriveConfig& config, std::string_view key);
Result<> setConfigText(DriveConfig& config, std::string_view key, std::string_view text);

// One axis of the reference mount after commissioning: id, gear ratio, the travel plus a margin of 3° as position
// bounds, hold (mode 10) after a time-out, fault 49 at 10° of following error, default limits, and gains for the
// inertia and friction of ReferenceAxis.
[[nodiscard]] DriveConfig commissionedDrive(Axis axis);
// The same for any axis.
[[nodiscard]] DriveConfig commissionedDrive(int id, const ReferenceAxis& mount);

}  // namespace boresight::sim
