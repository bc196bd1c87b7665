// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// The building blocks of the sample statuses.
namespace boresight::samples {

inline constexpr UtcTime kUtc = std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} + std::chrono::hours(17) +
                                std::chrono::minutes(5) + std::chrono::seconds(59);

// A drive with the settings that Boresight wants, and a crash-stop test made at noon.
[[nodiscard]] DriveStatus drive(Axis axis);
void place(StationStatus& status, AxisPosition actual, AxisPosition commanded, AxisPosition target);
void dropTarget(StationStatus& status);

}  // namespace boresight::samples
