// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

// The clock of the station's computer, in words. Pure.
namespace boresight::ui {

// "17:06:19Z", with a question mark if no time source sets the clock.
[[nodiscard]] QString utcText(const StationStatus& status);
// "±4.0 ms = 0.012°": the error of the clock, and its effect on the sky for the tracked target. "±4.0 ms" while no
// target needs the clock. "1 s = 0.624°", the effect of a second, if no time source sets it. Empty: the time source
// reports no error.
[[nodiscard]] QString clockErrorText(const StationStatus& status);
[[nodiscard]] QString widestClockErrorText();
// The same in sentences, and what to do.
[[nodiscard]] QString clockHelp(const StationStatus& status);

}  // namespace boresight::ui
