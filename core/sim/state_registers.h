// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/registers.h"
#include "core/sim/axis_plant.h"
#include "core/sim/power_supply.h"
#include "core/sim/rotor_encoder.h"
#include "core/sim/servo.h"

#include <array>
#include <cstdint>
#include <optional>

// The registers that show the state of a simulated drive: measured values, control loop, identity, encoders, clock. The
// registers that command it are in command_registers.h. Pure.
namespace boresight::sim {

inline constexpr int kFirmwareVersion = 0x010100;

// The parts of a drive. Valid only during one read.
struct DriveState
{
    const DriveConfig& config;
    const Servo& servo;
    const ServoInputs& inputs;
    const RotorEncoder& encoder;
    const BoardTemperature& board;
    const AxisPlant& plant;
    double uptime = 0.0;             // s
    std::array<unsigned, 2> pins{};  // of both aux ports; bit 0 is pin 0
    int registerMapVersion = moteus::kRegisterMapVersion;
};

// Registers that cannot be written. Empty for any other register.
[[nodiscard]] std::optional<double> readState(const DriveState& drive, moteus::Register reg);
// Encoders and the clock. Registers of parts that this board does not have (other encoders, analog pins, driver faults)
// read 0.
[[nodiscard]] double readSensor(const DriveState& drive, moteus::Register reg);

[[nodiscard]] std::array<std::uint32_t, 3> serialNumber(const DriveConfig& config);

}  // namespace boresight::sim
