// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/moteus/registers.h"

#include <cstdint>
#include <optional>

// Changes single values of a reply that is already on the wire. The other bytes stay as they are. Pure, any thread.
namespace boresight::sim {

// In units of the register. Empty: the reply does not contain it.
[[nodiscard]] std::optional<double> valueIn(const CanFrame& reply, moteus::Register reg);
// NaN is "unset". An infinity exists only as a float; an integer on the wire becomes "unset". A register that the reply
// does not contain changes nothing.
void setValue(CanFrame& reply, moteus::Register reg, double value);
// The reply ends before the block with the register.
void cutBefore(CanFrame& reply, moteus::Register reg);
// The drive that the reply seems to come from.
void setSource(CanFrame& reply, std::uint8_t id);

}  // namespace boresight::sim
