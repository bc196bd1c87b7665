// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/drives_status.h"
#include "core/moteus_mount/drive.h"

namespace boresight {

// The last reply of a drive as it was received, with its age. Nothing is filled in before the first reply, and nothing
// is kept from an earlier one: a quantity that the last reply does not contain is empty. Pure.
[[nodiscard]] DriveReadings readingsOf(const Drive& drive, SteadyTime now);

}  // namespace boresight
