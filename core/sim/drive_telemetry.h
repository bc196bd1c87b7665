// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim/console_record.h"
#include "core/sim/state_registers.h"

#include <string>
#include <string_view>
#include <vector>

// The telemetry channels of the console of a simulated drive, and their values. Pure.
namespace boresight::sim {

[[nodiscard]] std::vector<std::string> telemetryChannels();
// Empty if the channel does not exist.
[[nodiscard]] std::vector<ArchiveField> telemetry(const DriveState& drive, std::string_view channel);

}  // namespace boresight::sim
