// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/control/gates.h"

namespace boresight {

// Whether the rotator may make a home run. It drives its axes by itself, so no limit of Boresight holds meanwhile. It
// does not wait for brakes either: against a set brake its motors would lose steps.
[[nodiscard]] inline Result<> mayMakeHomeRun(const ControlParts& parts, const Source& by)
{
    const Gates gates(parts);
    const CurrentMotion& current = parts.current;
    return parts.mount.mayMakeHomeRun()
        .and_then([&]() -> Result<> {
            return parts.profile.brake.isUsed()
                       ? failure(
                             ErrorCode::NotAvailable,
                             Text::tr("The mount has brakes, and the rotator does not wait for them in a home run."))
                       : Result<>{};
        })
        .and_then([&] { return gates.mayPoint(by); })
        .and_then([&]() -> Result<> {
            return current.moves() && !current.goesToAPlace()
                       ? failure(ErrorCode::Refused, Text::tr("The mount tracks a target. Press Hold first."))
                       : Result<>{};
        })
        .and_then([&] { return gates.drivesRest(); })
        .and_then([&] { return gates.axesStand(); });
}

}  // namespace boresight
