// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/registers.h"

#include <string_view>

// Register 0x00f and the modes as texts for the operator. The code is a fault only while the mode is 1 (fault). In any
// other mode the codes 96..105 name the limit that is active now, and there is nothing to clear. Pure.
namespace boresight::moteus {

struct FaultText
{
    std::string_view name;     // short: "over temperature"
    std::string_view meaning;  // what happened, as a sentence without the full stop
    std::string_view cause;    // why it happens, most likely first
    std::string_view remedy;   // what to do
    bool saysRearm = false;    // the remedy contains "re-arm" already
};

// Every number has a text. 0 is "none", and undefined numbers are reported as undefined.
[[nodiscard]] FaultText faultText(int code);

// Codes of an active limit, which is no fault.
[[nodiscard]] bool isLimit(int code);

// The drive is in fault or its watchdog has expired, so it accepts only Stop.
[[nodiscard]] bool needsStop(Mode mode);

[[nodiscard]] std::string_view modeText(Mode mode);             // "position", "watchdog expired"
[[nodiscard]] std::string_view homeStateText(HomeState state);  // "output referenced"

}  // namespace boresight::moteus
