// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/control/gates.h"

namespace boresight {

// Whether the operator may type a line to the control box of the mount. Nothing moves, and nothing is about to move:
// the limits do not hold for such a line, and its answer takes the place of the next position.
[[nodiscard]] inline Result<> mayTypeLine(const ControlParts& parts)
{
    const Gates gates(parts);
    const CurrentMotion& current = parts.current;
    return parts.mount.mayType()
        .and_then([&]() -> Result<> {
            return current.moves() && !current.goesToAPlace()
                       ? failure(ErrorCode::Refused, Text::tr("The mount tracks a target. Press Hold first."))
                       : Result<>{};
        })
        .and_then([&] { return gates.drivesRest(); })
        .and_then([&] { return gates.axesStand(); });
}

}  // namespace boresight
