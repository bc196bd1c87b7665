// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/control/standstill_gate.h"

namespace boresight {

// Whether the rotator may make a home run. It drives its axes by itself, so no limit of Boresight holds meanwhile. It
// does not wait for brakes either: against a set brake its motors would lose steps.
[[nodiscard]] inline Result<> mayMakeHomeRun(const ControlParts& parts, const Source& by)
{
    return parts.mount.mayMakeHomeRun()
        .and_then([&]() -> Result<> {
            return parts.profile.brake.isUsed()
                       ? failure(
                             ErrorCode::NotAvailable,
                             Text::tr("The mount has brakes, and the rotator does not wait for them in a home run."))
                       : Result<>{};
        })
        .and_then([&] { return Gates(parts).mayPoint(by); })
        .and_then([&] { return standsWithoutTarget(parts); });
}

}  // namespace boresight
