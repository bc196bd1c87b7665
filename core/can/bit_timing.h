// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/can/interface_report.h"

#include <QString>

// The bit timing that moteus drives need, against the one an interface really has. A wrong one is the classic reason
// for silence: the bus looks healthy and no drive answers. Pure.
namespace boresight::socketcan {

// moteus: 1 Mbit/s arbitration, 5 Mbit/s data, sample point 0.666 in both phases.
inline constexpr PhaseTiming kWantedNominal{.bitRate = 1'000'000, .samplePoint = 0.666};
inline constexpr PhaseTiming kWantedData{.bitRate = 5'000'000, .samplePoint = 0.666};

// By its usual name, where nothing better is known.
[[nodiscard]] bool looksVirtual(const QString& interface);

// "ip link set can0 up type can bitrate …", or what a virtual interface needs.
[[nodiscard]] QString bringUpCommand(const QString& interface, bool isVirtual);

// What is wrong, found beside wanted, with the commands that set and show it; empty when all is right, and for a
// virtual interface, which has no timing.
[[nodiscard]] QString timingTrouble(const InterfaceReport& report);

}  // namespace boresight::socketcan
