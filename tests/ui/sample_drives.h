// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// What the samples of the station's statuses are put together from.
namespace boresight::samples {

inline constexpr UtcTime kUtc = std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} + std::chrono::hours(17) +
                                std::chrono::minutes(5) + std::chrono::seconds(59);

[[nodiscard]] DriveStatus drive(Axis axis);  // set as Boresight wants it, its crash stop proved this noon
void place(StationStatus& status, AxisPosition actual, AxisPosition commanded, AxisPosition target);
void dropTarget(StationStatus& status);

}  // namespace boresight::samples
