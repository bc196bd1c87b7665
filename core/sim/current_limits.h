// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim/drive_config.h"

// The electrical side of one drive: from a wanted torque to the current that the limits leave of it. Pure; A, V, Ω,
// Nm at the gearbox output, turns/s of the output, °C. Codes 96…105 of the fault register name the limit that bites.
namespace boresight::sim {

// Fault-register values that say which limit is active now. They are no faults.
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
    FieldWeakening = 105,  // told only when injected
};

struct ElectricalState
{
    double position = 0.0;
    double velocity = 0.0;
    double busVoltage = 24.0;
    double fetTemperature = 30.0;
    double motorTemperature = 0.0;
    bool boundsApply = false;  // modes 10 and 13 unless told to ignore them
};

struct LimitedCurrent
{
    double amperes = 0.0;
    ActiveLimit limit = ActiveLimit::None;
};

// Nm at the output per A of q current: 8.27/Kv at the rotor, 0.1 for a motor without a calibrated Kv.
[[nodiscard]] double torquePerAmpere(const DriveConfig& config);

// Back electromotive force in V per turn/s of the output.
[[nodiscard]] double voltagePerVelocity(const DriveConfig& config);

// Nm/(rad/s) on the output with the phases shorted: the back electromotive force drives a current through the winding.
[[nodiscard]] double brakeDamping(const DriveConfig& config);

// W: what the motor turns into motion (negative while braking) and into heat in its winding.
[[nodiscard]] double motorPower(const DriveConfig& config, double qCurrent, double dCurrent, double velocity);

// The fastest control velocity the bus voltage can drive, turns/s of the output.
[[nodiscard]] double velocityLimitOfSupply(const DriveConfig& config, double busVoltage);

[[nodiscard]] LimitedCurrent limitedCurrent(double wanted, const DriveConfig& config, const ElectricalState& state);

// d-axis current that burns what braking pumps into the supply.
[[nodiscard]] double fluxBrakeCurrent(const DriveConfig& config, double busVoltage);

}  // namespace boresight::sim
