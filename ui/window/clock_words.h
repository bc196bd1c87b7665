// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

// The clock of the computer of the station, in words. Pure.
namespace boresight::ui {

// "17:06:19Z", with a question mark where no time source sets it.
[[nodiscard]] QString utcText(const StationStatus& status);
// How far it is off, and how far the beam is off for that.
[[nodiscard]] QString clockHelp(const StationStatus& status);

}  // namespace boresight::ui
