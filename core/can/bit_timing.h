// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/can/interface_report.h"

#include <QString>

// Compares the bit timing of an interface with the timing that moteus drives need. Wrong timing is the usual reason for
// silence: the bus looks healthy, but no drive answers. Pure.
namespace boresight::socketcan {

// moteus: 1 Mbit/s arbitration, 5 Mbit/s data, sample point 0.666 in both phases.
inline constexpr PhaseTiming kWantedNominal{.bitRate = 1'000'000, .samplePoint = 0.666};
inline constexpr PhaseTiming kWantedData{.bitRate = 5'000'000, .samplePoint = 0.666};

// True if the interface has the usual name of a virtual one. For interfaces whose kind is not known.
[[nodiscard]] bool looksVirtual(const QString& interface);

// "ip link set can0 up type can bitrate …", or the command for a virtual interface.
[[nodiscard]] QString bringUpCommand(const QString& interface, bool isVirtual);

// The wrong values beside the wanted ones, with the commands that set and show them. Empty if all values are right, and
// for a virtual interface, which has no timing.
[[nodiscard]] QString timingTrouble(const InterfaceReport& report);

}  // namespace boresight::socketcan
