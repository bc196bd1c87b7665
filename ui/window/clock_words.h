// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

// The clock of the station's computer, in words. Pure.
namespace boresight::ui {

// "17:06:19Z", with a question mark if no time source sets the clock.
[[nodiscard]] QString utcText(const StationStatus& status);
// The error of the clock, and the error of the beam caused by it.
[[nodiscard]] QString clockHelp(const StationStatus& status);

}  // namespace boresight::ui
