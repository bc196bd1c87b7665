// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/schedule/night_plan.h"
#include "core/schedule/night_report.h"

#include <QString>

#include <cstdint>
#include <optional>

// The schedule of passes, as the station reports it. Plain values.
namespace boresight {

struct ScheduleStatus
{
    bool armed = false;
    QString why;  // why the schedule is not armed, or why there is no plan; may be empty
    schedule::NightPlan plan;
    std::optional<std::int64_t> tracked;  // the satellite of the pass that the mount tracks or waits for
    schedule::NightReport report;         // includes the passes before a restart and the pass that is being tracked

    bool operator==(const ScheduleStatus&) const = default;
};

}  // namespace boresight
