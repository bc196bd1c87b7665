// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/base/text.h"

namespace boresight::gs232 {

// The limits do not hold for a typed line, so a line that moves the rotator is not sent.
[[nodiscard]] inline Result<> refusalOfMotion()
{
    return failure(ErrorCode::Refused,
                   Text::tr("This line moves the rotator past the limits of Boresight. Use the page Jog."));
}

}  // namespace boresight::gs232
