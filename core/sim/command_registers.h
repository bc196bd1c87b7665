// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/registers.h"
#include "core/sim/servo_control.h"

#include <optional>

// The command registers 0x01a…0x01d, 0x020…0x02d and 0x040…0x048 as fields of one ServoCommand. Pure.
namespace boresight::sim {

// Empty if `reg` is no command register.
[[nodiscard]] std::optional<double> readCommand(const ServoCommand& command, moteus::Register reg);
// False if `reg` is no command register.
bool writeCommand(ServoCommand& command, moteus::Register reg, double value);

}  // namespace boresight::sim
