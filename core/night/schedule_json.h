// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/schedule_status.h"

#include <QByteArray>

// The plan and the report of the schedule for other programs: one line of JSON, times in UTC, angles in degrees. Pure.
namespace boresight {

// The next 100 passes, conflicts and hidden passes are in it.
[[nodiscard]] QByteArray planJson(const ScheduleStatus& status);
// The last 100 passes are in it.
[[nodiscard]] QByteArray reportJson(const schedule::NightReport& report);

}  // namespace boresight
