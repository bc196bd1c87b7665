// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/response/samples.h"

// How an axis goes from one position to another and stops there. The set-point may jump or move: overshoot is measured
// against its last position, and the settling time counts from its arrival there. Pure.
namespace boresight::response {

struct StepFigures
{
    Angle size;              // from the start to the last set-point
    double overshoot = 0.0;  // beyond the end, as a share of the size
    // From this time on the axis stays within the band. Empty: it is not within the band at the end of the samples.
    std::optional<Seconds> settling{};
    Angle band;  // "settled" means within this distance of the end
    Angle left;  // mean error in the last quarter of the time after the arrival
    ErrorFigures error;
    std::optional<TorqueFigures> torque{};

    bool operator==(const StepFigures&) const = default;
};

// The first sample is from before the step. An error explains why there is no result.
[[nodiscard]] Result<StepFigures> stepFigures(Samples samples, Angle band);

}  // namespace boresight::response
