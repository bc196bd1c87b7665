// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/recording/recording.h"
#include "core/units/sky.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

// The lines of a report: a recording with so many points as a page can show. Each line has several pieces where a part
// is unknown. Pure, any thread.
namespace boresight::pass_report {

struct TracePoint
{
    Seconds since{};  // the first tick
    double value = 0.0;

    bool operator==(const TracePoint&) const = default;
};

inline constexpr std::size_t kMeanOver = 4;

using TraceLine = std::vector<std::vector<TracePoint>>;
using SkyLine = std::vector<std::vector<SkyPointing>>;

struct PassTrace
{
    SkyLine target;
    SkyLine beam;
    SkyLine plan;                          // of the beam; empty if the mount is none with azimuth and elevation
    TraceLine error;                       // deg
    std::array<TraceLine, 2> torque = {};  // Nm, azimuth and elevation
    std::array<TraceLine, 2> meanTorque = {};
};

// Each line has at most two points, the least and the largest value, in each of the `columns` of the
// time. Means are of kMeanOver columns.
[[nodiscard]] PassTrace traceOf(const recording::Recording& recording, std::size_t columns);

// The direction with an elevation of at most 90°.
[[nodiscard]] SkyPointing upright(const SkyPointing& direction);

}  // namespace boresight::pass_report
