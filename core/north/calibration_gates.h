// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// What the operator may ask of the calibration desk now, from what its status says; `status` has the control's
// permissions. While a run moves the mount the screen offers no other motion: that would end the run. Pure, any thread.
namespace boresight {

void judgeCalibration(StationStatus& status);

}  // namespace boresight
