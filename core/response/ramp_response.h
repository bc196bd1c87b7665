// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/response/samples.h"

// How an axis follows a set-point that moves at a constant rate. Pure.
namespace boresight::response {

struct RampFigures
{
    AngularRate rate;                       // of the set-point, where it is constant
    Angle lag;                              // mean distance behind the set-point there; negative: ahead
    ErrorFigures steady;                    // there
    ErrorFigures error;                     // of all samples, with the beginning and the end
    std::optional<TorqueFigures> torque{};  // there

    bool operator==(const RampFigures&) const = default;
};

// The samples may hold what comes before and after. An error where nowhere in it the rate is constant for a second.
[[nodiscard]] Result<RampFigures> rampFigures(Samples samples);

}  // namespace boresight::response
