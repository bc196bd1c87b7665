// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// Decides which requests to the calibration desk are possible now, by its status. `status` also has the permissions of
// the control. While a run moves the mount, the screen offers no other motion, because that would end the run. Pure,
// any thread.
namespace boresight {

void judgeCalibration(StationStatus& status);
// Why this mount cannot be calibrated at all. Empty if it can.
[[nodiscard]] QString whyNoCalibration(const profile::Profile& profile);

}  // namespace boresight
