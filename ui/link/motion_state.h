// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// What the mount does now, as far as a panel or a prompt needs it in a word.
namespace boresight::ui {

[[nodiscard]] bool followsAClient(const StationStatus& status);  // a step then trims the client's target
[[nodiscard]] bool isMoving(const StationStatus& status);

}  // namespace boresight::ui
