// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/response/samples.h"

// How an axis follows a set-point that moves at a constant rate. Pure.
namespace boresight::response {

struct RampFigures
{
    AngularRate rate;                       // of the set-point, while it is constant
    Angle lag;                              // mean distance behind it in that time; negative: ahead
    ErrorFigures steady;                    // in that time
    ErrorFigures error;                     // of all samples, with the start and the end
    std::optional<TorqueFigures> torque{};  // in that time

    bool operator==(const RampFigures&) const = default;
};

// The samples may include the time before and after the ramp. An error if the rate is nowhere constant for 1 s.
[[nodiscard]] Result<RampFigures> rampFigures(Samples samples);

}  // namespace boresight::response
