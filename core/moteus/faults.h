// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/registers.h"

#include <string_view>

// Register 0x00f and the modes in words for the operator. The code is a fault only while the mode is 1 (fault); with
// any other mode the codes 96..105 name the limit that is active right now, and there is nothing to clear. Pure.
namespace boresight::moteus {

struct FaultText
{
    std::string_view name;     // short: "over temperature"
    std::string_view meaning;  // what happened, as a sentence without the full stop
    std::string_view cause;    // why it happens, most likely first
    std::string_view remedy;   // what to do
    bool saysRearm = false;    // the remedy does so itself
};

// Every number gives a text; 0 is "none", an undefined one says so.
[[nodiscard]] FaultText faultText(int code);

// Codes that tell of an active limit, not of a fault.
[[nodiscard]] bool isLimit(int code);

// The drive is in fault, or has latched its watchdog: only Stop leads out.
[[nodiscard]] bool needsStop(Mode mode);

[[nodiscard]] std::string_view modeText(Mode mode);             // "position", "watchdog expired"
[[nodiscard]] std::string_view homeStateText(HomeState state);  // "output referenced"

}  // namespace boresight::moteus
