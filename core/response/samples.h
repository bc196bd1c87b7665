// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <optional>
#include <span>

// The set-points of an axis and its answers over time, and the figures that every kind of run has. Plain values, any
// thread. Mechanical angles.
namespace boresight::response {

struct Sample
{
    Seconds time{0.0};
    Angle wanted;                    // the set-point
    Angle actual;                    // the measured position
    std::optional<double> torque{};  // Nm
};

using Samples = std::span<const Sample>;

// Figures of the tracking error, actual minus wanted.
struct ErrorFigures
{
    Angle rms;
    Angle peak;  // absolute value

    bool operator==(const ErrorFigures&) const = default;
};

struct TorqueFigures
{
    double rms = 0.0;   // Nm
    double peak = 0.0;  // Nm, absolute value

    bool operator==(const TorqueFigures&) const = default;
};

[[nodiscard]] ErrorFigures errorFigures(Samples samples);
// Empty if no sample has a torque.
[[nodiscard]] std::optional<TorqueFigures> torqueFigures(Samples samples);

}  // namespace boresight::response
