// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/recording/recording.h"
#include "core/units/sky.h"

#include <QString>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

// The numbers of a recorded pass. Pure, any thread. Empty: unknown.
namespace boresight::pass_report {

// A tick lasts until the next one, at most for this time. Longer times are without ticks.
inline constexpr Seconds kLongestTick{0.1};
// The beam counts as on target after this time without interruption, because a slewing beam may only cross the target.
inline constexpr Seconds kSettled{1.0};

// The angle between beam and target, after the first kSettled on target, to the end of the pass. If the beam was never
// on target: of all ticks. The parts that the limits of the mount hide by the plan do not count.
struct ErrorSummary
{
    Seconds counted{};
    Angle rms;
    Angle median;
    Angle most95;  // 95 % of the ticks have at most this error
    Angle peak;
    std::optional<double> peakLoss;  // dB; empty beyond the main lobe
    UtcTime peakAt{};
    std::optional<SkyPointing> peakTarget;
    std::optional<Seconds> beyond;  // above half of the beam width; empty: the beam width is unknown

    bool operator==(const ErrorSummary&) const = default;
};

// A value with the largest magnitude, and where it was.
struct Extreme
{
    double value = 0.0;
    UtcTime utc{};
    std::optional<Angle> position;  // of the axis

    bool operator==(const Extreme&) const = default;
};

struct AxisSummary
{
    std::optional<Extreme> torque;     // Nm
    std::optional<Extreme> rate;       // deg/s
    std::optional<double> meanTorque;  // Nm, of the magnitudes

    bool operator==(const AxisSummary&) const = default;
};

// The plan, and how far the axes were from it.
struct PlanSummary
{
    plan::PlanWay way = plan::PlanWay::Direct;
    plan::Forecast forecast;
    std::optional<Angle> azimuthOff;  // the largest magnitude, of the same ticks as the error
    std::optional<Angle> elevationOff;

    bool operator==(const PlanSummary&) const = default;
};

struct PassSummary
{
    recording::Header header;
    UtcTime from{};                      // of the first tick
    UtcTime to{};                        // of the last tick
    std::optional<SkyPointing> highest;  // direction of the target
    std::optional<Seconds> untilOnTarget;
    std::optional<ErrorSummary> error;
    std::array<AxisSummary, 2> axes;
    std::optional<PlanSummary> plan;
    std::optional<double> wind;  // m/s, the largest
    std::size_t ticks = 0;
    std::uint64_t lostTicks = 0;
    Seconds withoutTicks{};
    std::size_t damages = 0;  // parts of the file that could not be read, without a missing end
    bool hasEnd = false;
    std::size_t alarms = 0;  // events of the level Alarm
    std::size_t warnings = 0;
    std::size_t motions = 0;  // how often a source began to move the mount

    [[nodiscard]] const AxisSummary& axis(Axis one) const { return axes[index(one)]; }
    bool operator==(const PassSummary&) const = default;
};

// The events of the last second before the first tick count, too: the start of the motion is one of them. Older events
// belong to something else.
inline constexpr Seconds kBeforeTicks{1.0};

// The ticks that were not stored.
[[nodiscard]] std::uint64_t lostTicks(const recording::Recording& recording);

// The error: the recording has no ticks.
[[nodiscard]] Result<PassSummary> summaryOf(const recording::Recording& recording);

// The events that a report shows, in the order of time: alarms and warnings before the beginnings of motions, before
// other events. Lines of clients are left out. At most `most`.
[[nodiscard]] std::vector<recording::Event> importantEvents(const recording::Recording& recording, std::size_t most);

}  // namespace boresight::pass_report
