// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// What a station with such a status would permit, in the sentences of its gates. They are tested where they are, in
// tests/core/control/permissions_test.cpp: here it only matters that the window shows them.
namespace boresight::samples {

// What a test has refused itself stays.
[[nodiscard]] StationStatus judged(StationStatus status);

}  // namespace boresight::samples
