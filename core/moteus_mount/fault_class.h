// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/supervision/retry_policy.h"

namespace boresight {

// Of a moteus fault code (mode 1). Unknown codes are Driver.
[[nodiscard]] supervision::LossClass classOfFault(int code);

}  // namespace boresight
