// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/can/can_link.h"

#include <memory>

// Makes the bus of a name: "socketcan:IFACE", "fdcanusb:PATH" or "simulated". Not opened yet.
namespace boresight {

[[nodiscard]] Result<std::unique_ptr<CanLink>> makeLink(const std::string& busName, const Clock& clock);

}  // namespace boresight
