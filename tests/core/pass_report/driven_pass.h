// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recording/recording.h"

#include <chrono>
#include <vector>

// A recording with numbers that can be worked out by hand: a tick each 0.1 s, a beam of 1°.
namespace boresight::pass_report {

inline constexpr UtcTime kDrivenFrom{std::chrono::milliseconds(1'795'000'000'000)};  // 2026-11-18 11:06:40 UTC

inline UtcTime drivenAt(int tick)
{
    return kDrivenFrom + std::chrono::milliseconds(100) * tick;
}

inline recording::Recording drivenPass(const std::vector<double>& errors)
{
    recording::Recording made{.header = {.program = QStringLiteral("Boresight 0.1.0"),
                                         .mount = QStringLiteral("Roof"),
                                         .beamWidth = Angle::fromDegrees(1.0),
                                         .target = QStringLiteral("NOAA 19"),
                                         .number = 33591},
                              .hasEnd = true};
    for (std::size_t i = 0; i < errors.size(); ++i) {
        recording::Tick tick{.utc = drivenAt(static_cast<int>(i))};
        tick.error = Angle::fromDegrees(errors[i]);
        tick.target = SkyPointing{Angle::fromDegrees(100.0), Angle::fromDegrees(10.0 + static_cast<double>(i))};
        tick.actual = tick.target;
        for (recording::AxisTick& axis : tick.axes) {
            axis.torque = 0.5;
            axis.rate = AngularRate::fromDegrees(1.0);
        }
        tick.axes[0].actual = Angle::fromDegrees(460.0);
        tick.axes[1].actual = tick.actual->elevation;
        made.ticks.push_back(tick);
    }
    return made;
}

// A slew of 1 s with an error of 5°, then 26 ticks with 0.3°, of which 10 are the first second on target, 3 ticks with
// 0.4°, and one with 1.2°.
inline recording::Recording drivenPass()
{
    std::vector<double> errors(10, 5.0);
    errors.insert(errors.end(), 26, 0.3);
    errors.insert(errors.end(), {0.4, 1.2, 0.4, 0.4});
    return drivenPass(errors);
}

// The axes of drivenPass() by a plan of these ticks: 0.5° beside the azimuth.
inline plan::PlanVariant planOfDrivenPass(int from, int to)
{
    plan::PlanVariant made{
        .way = plan::PlanWay::OverTheTop,
        .forecast = {.peak = Angle::fromDegrees(0.2), .rms = Angle::fromDegrees(0.1), .peakLoss = 0.48}};
    for (int i = from; i <= to; ++i) {
        made.moments.push_back({.utc = drivenAt(i),
                                .axes = {Angle::fromDegrees(459.5), Angle::fromDegrees(10.0 + i)},
                                .rates = {{}, AngularRate::fromDegrees(10.0)}});
    }
    return made;
}

}  // namespace boresight::pass_report
