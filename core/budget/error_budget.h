// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <QString>

#include <optional>
#include <vector>

// The pointing error of the mount in its parts, and their sum. A value. Any thread.
namespace boresight::budget {

enum class ErrorPart
{
    Servo,        // the measured axes beside their set-points
    Way,          // the set-points beside the target
    Stream,       // the path between the points of a client, or between computed positions
    Clock,        // the time by which the target is computed
    Elements,     // the orbit of the satellite
    Calibration,  // the beam beside the direction that the axes show
    Wind          // what the wind bends. It is never in the sum
};

struct ErrorLine
{
    ErrorPart part = ErrorPart::Servo;
    std::optional<Angle> error;  // on the sky; empty: unknown, and not in the sum
    QString basis;               // where the number comes from, or why there is none; sentences

    bool operator==(const ErrorLine&) const = default;
};

struct ErrorBudget
{
    std::vector<ErrorLine> lines;  // the parts that apply to the present target, in the order of ErrorPart
    Angle sum;                     // of the known parts, added as squares
    bool isWhole = true;           // false: a part is unknown, so the error is at least `sum`
    std::optional<double> loss;    // dB, of `sum` in the beam in use; empty beyond the main lobe

    bool operator==(const ErrorBudget&) const = default;
};

}  // namespace boresight::budget
