// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim/drive_config.h"

// The electrical side of one drive: how much current remains of the wanted torque after all limits. Pure. Units: A, V,
// Ω, Nm at the gearbox output, turns/s of the output, °C.
namespace boresight::sim {

// Values 96…105 of the fault register name the limit that is active now. They are no faults.
enum class ActiveLimit
{
    None = 0,
    MaxVelocity = 96,
    MaxPower = 97,
    BusVoltage = 98,
    MaxCurrent = 99,
    FetTemperature = 100,
    MotorTemperature = 101,
    CommandedTorque = 102,
    PositionBounds = 103,
    FluxBraking = 104,
    FieldWeakening = 105,  // reported only when injected
};

struct ElectricalState
{
    double position = 0.0;
    double velocity = 0.0;
    double busVoltage = 24.0;
    double fetTemperature = 30.0;
    double motorTemperature = 0.0;
    bool boundsApply = false;  // in modes 10 and 13, unless the command ignores the bounds
};

struct LimitedCurrent
{
    double amperes = 0.0;
    ActiveLimit limit = ActiveLimit::None;
};

// Nm at the output per A of q current: 8.27/Kv at the rotor, or 0.1 at the rotor for a motor without a calibrated Kv.
[[nodiscard]] double torquePerAmpere(const DriveConfig& config);

// Back electromotive force in V per turn/s of the output.
[[nodiscard]] double voltagePerVelocity(const DriveConfig& config);

// Nm/(rad/s) at the output with shorted phases: the back electromotive force drives a current through the winding.
[[nodiscard]] double brakeDamping(const DriveConfig& config);

// W: the power that the motor turns into motion (negative while braking) plus the heat in its winding.
[[nodiscard]] double motorPower(const DriveConfig& config, double qCurrent, double dCurrent, double velocity);

// The fastest control velocity that the bus voltage allows, in turns/s of the output.
[[nodiscard]] double velocityLimitOfSupply(const DriveConfig& config, double busVoltage);

[[nodiscard]] LimitedCurrent limitedCurrent(double wanted, const DriveConfig& config, const ElectricalState& state);

// The d-axis current that turns the power from braking into heat.
[[nodiscard]] double fluxBrakeCurrent(const DriveConfig& config, double busVoltage);

}  // namespace boresight::sim
