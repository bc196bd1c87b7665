// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/control/control_parts.h"

// What an X/Y mount does not have.
namespace boresight {

[[nodiscard]] inline Result<> hasCable(const ControlParts& parts)
{
    return parts.model.pointing().isXY()
               ? failure(ErrorCode::NotAvailable, Text::tr("An X/Y mount has no cable to unwrap."))
               : Result<>{};
}

// An axis that lowers the beam to the horizon.
[[nodiscard]] inline Result<> hasElevationAxis(const ControlParts& parts)
{
    return parts.model.pointing().isXY()
               ? failure(ErrorCode::NotAvailable,
                         Text::tr("An X/Y mount has no elevation axis to lower. Go to a direction instead."))
               : Result<>{};
}

}  // namespace boresight
