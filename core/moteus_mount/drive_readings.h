// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/drives_status.h"
#include "core/moteus_mount/drive.h"

namespace boresight {

// The last reply of a drive as it was received, with its age. Before the first reply all quantities are empty. A
// quantity that the last reply does not contain is empty, too. Pure.
[[nodiscard]] DriveReadings readingsOf(const Drive& drive, SteadyTime now);

}  // namespace boresight
