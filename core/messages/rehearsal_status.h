// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/schedule/night_plan.h"
#include "core/schedule/night_report.h"
#include "core/units/sky.h"

#include <QString>

#include <memory>
#include <optional>
#include <vector>

// The result of running the schedule ahead of time on a simulated copy of the mount. Plain values. Mechanical angles.
namespace boresight {

struct RehearsedNight
{
    // A warning that the station would log, and the time of it.
    struct Remark
    {
        UtcTime utc{};
        QString text;

        bool operator==(const Remark&) const = default;
    };

    UtcTime from{};
    UtcTime to{};  // the end of the last pass, or when the schedule would be disarmed
    schedule::NightPlan plan;
    schedule::NightReport report;
    Angle leastAzimuth;  // smallest and largest azimuth of the axis
    Angle mostAzimuth;
    std::vector<Remark> remarks;  // in the order of time
    QString disarmed;             // why the schedule would be disarmed before its last pass; empty: it would not

    bool operator==(const RehearsedNight&) const = default;
};

struct RehearsalStatus
{
    std::optional<double> progress;               // 0 to 1; empty: no rehearsal is running
    QString problem;                              // why the last rehearsal has no result
    std::shared_ptr<const RehearsedNight> night;  // the last result; null: there is none
};

}  // namespace boresight
