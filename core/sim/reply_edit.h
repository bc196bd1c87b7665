// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/moteus/registers.h"

#include <cstdint>
#include <optional>

// Changes single values in an encoded reply. The other bytes stay as they are. Pure, any thread.
namespace boresight::sim {

// The value of the register in its own unit. Empty if the reply does not contain the register.
[[nodiscard]] std::optional<double> valueIn(const CanFrame& reply, moteus::Register reg);
// NaN means "not set". Only a float can carry an infinity, so in an integer it becomes "not set". If the reply does not
// contain the register, nothing changes.
void setValue(CanFrame& reply, moteus::Register reg, double value);
// Ends the reply before the block that contains the register.
void cutBefore(CanFrame& reply, moteus::Register reg);
// Sets the id that the reply seems to come from.
void setSource(CanFrame& reply, std::uint8_t id);

}  // namespace boresight::sim
