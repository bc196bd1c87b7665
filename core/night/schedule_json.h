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

// The next 100 passes, conflicts and hidden passes are in it.
[[nodiscard]] QByteArray planJson(const ScheduleStatus& status);
// The last 100 passes are in it. The errors of one that was never on target are null.
[[nodiscard]] QByteArray reportJson(const schedule::NightReport& report);
// "progress" is null when none runs, "night" is null without a result.
[[nodiscard]] QByteArray rehearsalJson(const RehearsalStatus& status);
// All keys are there. What does not apply is null.
[[nodiscard]] QJsonObject momentObject(const schedule::PassMoment& moment, const QString& mount, bool simulated);

}  // namespace boresight
