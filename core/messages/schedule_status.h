// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/schedule/night_plan.h"
#include "core/schedule/night_report.h"

#include <QString>

#include <cstdint>
#include <optional>

// The schedule of passes, as the station tells it. Plain values.
namespace boresight {

struct ScheduleStatus
{
    bool armed = false;
    QString why;  // it is not armed, or there is no plan; may be empty
    schedule::NightPlan plan;
    std::optional<std::int64_t> tracked;  // the satellite of the pass that the mount tracks or waits for
    schedule::NightReport report;         // also before a restart, with the pass that is tracked

    bool operator==(const ScheduleStatus&) const = default;
};

}  // namespace boresight
