// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim/console_record.h"
#include "core/sim/rotor_encoder.h"

#include <vector>

// The telemetry channel "motor_position", which reports the encoders of a drive, as firmware of 2026 does: three
// encoder slots, of which the first is used. Pure.
namespace boresight::sim {

[[nodiscard]] std::vector<ArchiveField> encoderReport(const RotorEncoder& encoder);

}  // namespace boresight::sim
