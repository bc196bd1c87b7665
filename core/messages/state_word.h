// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

namespace boresight {

// The names of states for programs. They are never translated. A state of the station: for example "TRACK".
[[nodiscard]] QString protocolWord(StationState state);
// The state of the brake for programs: "set", "opens", "open", "closes", or "failed" while its output does not work.
[[nodiscard]] QString protocolWord(const BrakeStatus& brake);

// "azimuth lower", "elevation upper", …
[[nodiscard]] QString protocolWord(const end_switches::EndSwitch& one);
// The state of the third axis: "no data", "off", "holding", "moving", "fault".
[[nodiscard]] QString protocolWord(ThirdAxisStatus::State state);
// "free", "pressed" or "unread".
[[nodiscard]] QString protocolWord(end_switches::SwitchState state);

}  // namespace boresight
