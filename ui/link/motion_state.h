// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// The present motion of the mount, as panels and prompts need it.
namespace boresight::ui {

[[nodiscard]] bool followsAClient(const StationStatus& status);  // a step then trims the client's target
[[nodiscard]] bool isMoving(const StationStatus& status);

}  // namespace boresight::ui
