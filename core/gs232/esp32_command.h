// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <string>
#include <string_view>

// The commands to the ESP32 relay controller, which calls itself a GS-232 box and speaks words. Pure.
namespace boresight::gs232::esp32 {

inline constexpr std::string_view kAskVersion = "VE\r";
inline constexpr std::string_view kAskPlace = "P\r";
inline constexpr std::string_view kSwitchReports = "DEBUG\r";  // on, or off if they are on
inline constexpr std::string_view kAskOffsets = "CALSTATS\r";
// Switches both relays off. The box keeps its targets, and switches the relays on again within half a second.
inline constexpr std::string_view kRelaysOff = "SA\rSE\r";

// A typed line that moves the rotator: a target, HOME or DANCE.
[[nodiscard]] bool movesWhenTyped(std::string_view line);

// "AZ 123.4": the target of one axis.
[[nodiscard]] std::string goTo(Axis axis, Angle angle);

}  // namespace boresight::gs232::esp32
