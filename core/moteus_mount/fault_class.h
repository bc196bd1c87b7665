// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/supervision/retry_policy.h"

namespace boresight {

// The class of a moteus fault code (mode 1). Unknown codes are LossClass::Driver.
[[nodiscard]] supervision::LossClass classOfFault(int code);

}  // namespace boresight
