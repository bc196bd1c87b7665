// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/end_switch_status.h"

#include <QString>

// The end switches in words. Pure.
namespace boresight::ui {

[[nodiscard]] QString endName(const end_switches::EndSwitch& which);  // "AZ upper end"
[[nodiscard]] QString endSwitchLine(const EndSwitchStatus& one);      // "AZ upper end: free (mqtt:roof/end)"

}  // namespace boresight::ui
