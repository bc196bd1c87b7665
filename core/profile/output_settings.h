// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"

#include <string>

namespace boresight::profile {

// Whether an output must be opened again: it has another name, or another broker switches it.
[[nodiscard]] bool isAnotherOutput(const std::string& before, const BrokerSettings& brokerBefore,
                                   const std::string& after, const BrokerSettings& brokerAfter);

}  // namespace boresight::profile
