// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/standstill_gate.h"

namespace boresight {

// Whether the operator may type a line to the control box of the mount. Nothing moves, and nothing is about to move:
// the limits do not hold for such a line, and its answer takes the place of the next position.
[[nodiscard]] inline Result<> mayTypeLine(const ControlParts& parts)
{
    return parts.mount.mayType().and_then([&] { return standsWithoutTarget(parts); });
}

}  // namespace boresight
