// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/rehearsal_status.h"
#include "core/messages/schedule_status.h"
#include "core/schedule/pass_moment.h"

#include <QByteArray>
#include <QJsonObject>

// The plan, the report and the rehearsal of the schedule for other programs: one line of JSON, times in UTC, angles in
// degrees. Pure.
namespace boresight {

// Contains at most the next 100 passes, conflicts and hidden passes.
[[nodiscard]] QByteArray planJson(const ScheduleStatus& status);
// Contains at most the last 100 passes. For a pass that was never on target the errors are null.
[[nodiscard]] QByteArray reportJson(const schedule::NightReport& report);
// "progress" is null if no rehearsal is running. "night" is null if there is no result.
[[nodiscard]] QByteArray rehearsalJson(const RehearsalStatus& status);
// Always contains all keys. A key that does not apply is null.
[[nodiscard]] QJsonObject momentObject(const schedule::PassMoment& moment, const QString& mount, bool simulated);

}  // namespace boresight
