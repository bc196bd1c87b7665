// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

// The state of program, computer, drives and station as texts for the person who repairs them. English; times in UTC.
namespace boresight::diagnostics {

[[nodiscard]] QString utcText(UtcTime time);                      // 2026-11-21T18:17:30Z
[[nodiscard]] QString versionsText(const StationStatus& status);  // program, Qt, system, drives
[[nodiscard]] QString drivesText(const StationStatus& status);    // their configuration as read, crash-stop tests
[[nodiscard]] QString stationText(const StationStatus& status);   // state, axes, bus, clients, alarms

}  // namespace boresight::diagnostics
