// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/control/drive_gates.h"

namespace boresight {

// Nothing moves, and nothing is about to move. For acts at the control box during which no limit of Boresight holds.
[[nodiscard]] inline Result<> standsWithoutTarget(const ControlParts& parts)
{
    const DriveGates gates(parts);
    if (parts.current.moves() && !parts.current.goesToAPlace()) {
        return failure(ErrorCode::Refused, Text::tr("The mount tracks a target. Press Hold first."));
    }
    return gates.drivesRest().and_then([&] { return gates.axesStand(); });
}

}  // namespace boresight
