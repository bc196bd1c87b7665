// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/schedule/night_plan.h"
#include "core/schedule/night_report.h"
#include "core/units/sky.h"

#include <QString>

#include <memory>
#include <optional>
#include <vector>

// The schedule as it was run ahead of time on a simulated copy of the mount. Plain values. Angles of the axis.
namespace boresight {

struct RehearsedNight
{
    // What the station would log as a warning, at the time at which it would.
    struct Remark
    {
        UtcTime utc{};
        QString text;

        bool operator==(const Remark&) const = default;
    };

    UtcTime from{};
    UtcTime to{};  // when the last pass is over, or when the schedule would be disarmed
    schedule::NightPlan plan;
    schedule::NightReport report;
    Angle leastAzimuth;  // between these the cable is used
    Angle mostAzimuth;
    std::vector<Remark> remarks;  // in their order
    QString disarmed;             // why the schedule would end before its last pass; empty: it would not

    bool operator==(const RehearsedNight&) const = default;
};

struct RehearsalStatus
{
    std::optional<double> progress;               // 0 to 1; empty: none runs
    QString problem;                              // why the last one came to nothing
    std::shared_ptr<const RehearsedNight> night;  // the last one; nullptr: none was made, or it came to nothing
};

}  // namespace boresight
