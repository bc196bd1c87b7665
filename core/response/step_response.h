// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/response/samples.h"

// How an axis goes from one place to another and comes to rest there. The set-point may jump or move: overshoot is
// measured against its last place, and the time to settle counts from when it arrived there. Pure.
namespace boresight::response {

struct StepFigures
{
    Angle size;                         // from where it began to the last set-point
    double overshoot = 0.0;             // beyond the end, as a part of the size
    std::optional<Seconds> settling{};  // then it stays within the band; empty: not before the samples end
    Angle band;                         // "settled" is within this of the end
    Angle left;                         // the mean error of the last quarter after the arrival
    ErrorFigures error;
    std::optional<TorqueFigures> torque{};

    bool operator==(const StepFigures&) const = default;
};

// The first sample is before the step. An error says why there is no result.
[[nodiscard]] Result<StepFigures> stepFigures(Samples samples, Angle band);

}  // namespace boresight::response
